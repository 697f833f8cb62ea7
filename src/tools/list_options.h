// Option values of the measuring programs: lists, and other programs to measure.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include "bench/benchmark.h"
#include "bench/child_process.h"
#include "collision_hulls/error.h"
#include "decompose_options.h"

namespace collision_hulls {

/// The items of a comma-separated list.
template <typename T>
std::vector<T> parsedList(const std::string& text, const std::function<T(const std::string&)>& parse) {
  std::vector<T> items;
  std::istringstream in(text);
  for (std::string item; std::getline(in, item, ',');) items.push_back(parse(item));
  return items;
}

/// The value of --methods.
inline std::vector<Method> methodsIn(const std::string& list) {
  return parsedList<Method>(list, [](const std::string& text) { return choice("--methods", text, methodNamed, methodChoices()); });
}

/// Parses NAME=COMMAND, or NAME alone, which means the program peer_NAME in the folder `programs`. Throws kBadOption if that does not
/// exist.
inline Peer peerOf(const std::string& text, const std::filesystem::path& programs) {
  const std::size_t equals = text.find('=');
  if (equals != std::string::npos) return {text.substr(0, equals), text.substr(equals + 1)};
  const std::string program = (programs / ("peer_" + text)).string();
  if (access(program.c_str(), X_OK) == 0) return {text, filledIn("{program}", {{"program", program}}) + " {in} {out} {tolerance}"};
  throw Error(ErrorCode::kBadOption,
              "--peer '" + text + "': there is no program '" + program +
                  "'; install the library that it wraps and build again, or give a command, NAME='program {in} {out} {tolerance}'");
}

/// The values of --peer. `program`: the path of the one that was started with them.
inline std::vector<Peer> peersOf(const std::vector<std::string>& texts, const std::string& program) {
  std::vector<Peer> peers;
  for (const std::string& text : texts) peers.push_back(peerOf(text, std::filesystem::path(program).parent_path()));
  return peers;
}

}  // namespace collision_hulls
