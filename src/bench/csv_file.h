// A CSV file that is written line by line, so that an interrupted run keeps what it measured.
#pragma once

#include <cerrno>
#include <cstring>
#include <fstream>
#include <string>

#include "storage/files.h"

namespace collision_hulls {

class CsvFile {
 public:
  /// Replaces an existing file. Throws kUnwritableOutput, as add() does.
  CsvFile(const std::string& path, const std::string& header) : path_(path), stream_(path, std::ios::trunc) { add(header); }

  /// Appends one or more lines, each with its line break.
  void add(const std::string& line) {
    if (stream_) errno = 0;
    if (!(stream_ << line << std::flush)) throwUnwritable(path_, errno ? std::strerror(errno) : "writing failed");
  }

 private:
  const std::string path_;
  std::ofstream stream_;
};

}  // namespace collision_hulls
