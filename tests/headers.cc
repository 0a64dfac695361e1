// Nothing of its own: the target of the precompiled headers needs a source.
