// Files that options name for what a program writes.
#pragma once

#include <filesystem>
#include <string>
#include <system_error>

#include "collision_hulls/error.h"
#include "storage/files.h"

namespace collision_hulls {

/// Throws kUnwritableOutput for a file in a folder that is not there, most likely a slip, before a run of minutes makes that folder.
inline void expectFolderOf(const std::string& file) {
  std::error_code none;
  const std::filesystem::path folder = behindLinks(file).parent_path();
  if (folder.empty() || std::filesystem::is_directory(folder, none)) return;
  throw Error(ErrorCode::kUnwritableOutput,
              "cannot write '" + file + "': there is no folder '" + folder.string() + "'; create it, or give another file");
}

}  // namespace collision_hulls
