// Feeds files to all targets without libFuzzer: FOLDER/TARGET/* to TARGET. Prints each before it is taken, so that the last line of a crash
// names what caused it.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

#include "fuzz/target.h"

namespace fs = std::filesystem;
using namespace collision_hulls::fuzz;

namespace {

std::vector<fs::path> filesIn(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::string contentOf(const fs::path& file) {
  std::ostringstream content;
  content << std::ifstream(file, std::ios::binary).rdbuf();
  return content.str();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: replay FOLDER    with a folder of inputs for each target\n";
    return 2;
  }
  for (const Target& target : targets()) {
    const fs::path folder = fs::path(argv[1]) / target.name;
    if (!fs::is_directory(folder)) {
      std::cerr << "'" << folder.string() << "' is missing: every target needs inputs\n";
      return 1;
    }
    for (const fs::path& file : filesIn(folder)) {
      std::cout << file.string() << std::endl;
      feed(target, contentOf(file));
    }
  }
}
