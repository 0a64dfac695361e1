#pragma once

#include "whittle/io/file_notes.hh"
#include "whittle/progressive/recording.hh"

// What a file says beside its mesh, as recordings have it. docs/dev/format.md lists the notes.

namespace whittle::app {

/// What a new glTF file of the run calls the mesh: a note of one text.
inline constexpr char mesh_name_note[] = "mesh_name";

/// Without what writers do anyway. So a plain mesh has no notes.
progressive::RecordingNotes recorded_notes(const io::FileNotes& notes);

/// The other way. Notes that aren't known are left out. \throw progressive::RecordingError
io::FileNotes file_notes_of(const progressive::RecordingNotes& recorded);

}  // namespace whittle::app
