#pragma once

#include "whittle/io/file_notes.hh"
#include "whittle/progressive/recording.hh"

// Content of a file beside its mesh, in recordings. docs/dev/format.md lists the notes.

namespace whittle::app {

/// Name of the mesh in a new glTF file of the run: a note of one text.
inline constexpr char mesh_name_note[] = "mesh_name";

/// The notes that differ from writers' defaults. So a plain mesh has no notes.
progressive::RecordingNotes recorded_notes(const io::FileNotes& notes);

/// The other way. Notes that aren't known are left out. \throw progressive::RecordingError
io::FileNotes file_notes_of(const progressive::RecordingNotes& recorded);

}  // namespace whittle::app
