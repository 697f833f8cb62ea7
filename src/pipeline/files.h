// Whole files, written and read back.
#pragma once

#include <filesystem>
#include <string>

namespace collision_hulls {

/// The content of a file; empty where it cannot be read.
std::string readText(const std::filesystem::path& file);

/// Writes a file (and the folders above it), reads it back and compares. Throws kUnwritableOutput with the system's reason.
void writeText(const std::filesystem::path& file, const std::string& text);

/// Writes a file that a user names: in one rename where it is a plain file or none is there yet, also behind links; into it where it is a
/// pipe or a device. Throws kUnwritableOutput.
void writeNamedFile(const std::filesystem::path& file, const std::string& text);

/// Throws kUnwritableOutput where that would certainly fail.
void checkNamedFile(const std::filesystem::path& file);

/// Throws kUnwritableOutput where the nearest folder above an absolute path that is there is none to write in.
void checkFolderOf(const std::filesystem::path& path);

/// kUnwritableOutput for a path, with what went wrong and what to do.
[[noreturn]] void throwUnwritable(const std::filesystem::path& path, const std::string& why);

}  // namespace collision_hulls
