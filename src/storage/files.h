// Whole files, written and read back.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "base/descriptor.h"
#include "collision_hulls/control.h"

namespace collision_hulls {

/// The content of a regular file; nullopt if it cannot be read, is something else or has more bytes. For the program's own files, wherever
/// they lie; for those that a user names, which have to be there and below the roots (base/roots.h): readFile() and readTextFile().
std::optional<std::string> contentOf(const std::filesystem::path& file, std::uintmax_t most_bytes);

/// Writes a file (and the folders above it), reads it back and compares. Throws kUnwritableOutput with the system's reason.
void writeText(const std::filesystem::path& file, const std::string& text);

/// create_directories(), but below links as well, where that of GCC before 11.3 fails.
void makeFolders(const std::filesystem::path& folder, std::error_code& error);

/// A path to an open folder, wherever that is moved.
std::filesystem::path placeOf(const Descriptor& folder);

/// The folder around a path, opened. A part of the path may have become a link since it was checked, so what is checked against the roots
/// is the path's place in the folder that is open now. Throws kUnwritableOutput, kOutsideRoots.
Descriptor openedAround(const std::filesystem::path& path);

/// Writes a file that a user names: in one rename if it is a plain file or does not exist yet, also behind symbolic links; straight into
/// it if it is a pipe or a device; a pipe that nobody reads is an error. `control` ends the wait for a reader that does not read. Throws
/// kUnwritableOutput, and kOutsideRoots if the path leads out of the roots by now.
void writeNamedFile(const std::filesystem::path& file, const std::string& text, const RunControl& control = {});

/// Throws kUnwritableOutput if that would fail. Leaves nothing behind.
void checkNamedFile(const std::filesystem::path& file);

/// Throws kUnwritableOutput if a file is there that neither is empty nor begins with this text, which has no white space; that of the file
/// does not count. `what` the file should hold is for the message: whoever names another for such an output most likely errs.
void checkBeginsWith(const std::filesystem::path& file, const std::string& beginning, const std::string& what);

/// checkBeginsWith() for the report of any program: its first key is collision_hulls. A .gltf file is JSON, too, but no report.
void checkHoldsReport(const std::filesystem::path& file);

/// Where a file's name leads, through symbolic links, also to where nothing is yet.
std::filesystem::path behindLinks(std::filesystem::path file);

/// Throws kUnwritableOutput unless something can be created in the nearest existing folder above an absolute path, and tries that.
void checkFolderOf(const std::filesystem::path& path);

/// Brings a file or folder to the disk: `sync` is fsync or syncfs. 0 or errno; a file system that cannot do this is no error.
int syncPath(const std::filesystem::path& path, int (*sync)(int));

/// Throws kUnwritableOutput for a path, with the reason and the remedy.
[[noreturn]] void throwUnwritable(const std::filesystem::path& path, const std::string& why);

}  // namespace collision_hulls
