// Which meshes a run works on, and which of them are the same.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "collision_hulls/pipeline/decompose_robot.h"

namespace collision_hulls {

/// Tells whether Options::links chooses a link.
class LinkChoice {
 public:
  /// Throws kBadOption where the expression matches no link of the robot.
  LinkChoice(const std::string& expression, const RobotDescription& robot);
  bool operator()(const std::string& link) const { return matches_(link); }

 private:
  std::function<bool(const std::string&)> matches_;
};

/// The result with which a run on a robot begins: an element for every mesh of every chosen link, in document order, nothing computed.
RobotResult robotResult(const RobotDescription& robot, const Options& options);

/// Notes on meshes that Options::source leaves out, and on a robot in which it finds none.
std::vector<std::string> notesOnElements(const RobotDescription& robot, const std::vector<ElementResult>& elements, const Options& options);

/// A mesh to work on, for all elements (indices) with the same content, kind of file and scale.
struct MeshTask {
  std::string file;
  std::uintmax_t bytes = 0;
  std::vector<std::size_t> elements;             ///< ascending
  std::filesystem::file_time_type changed = {};  ///< when the file was last changed, as seen before its sha256 was taken
};

/// Finds the elements' files and fills their sha256; an element without a file becomes a failed row and is in no task.
/// Largest file first, so that no long task begins last.
std::vector<MeshTask> meshTasks(std::vector<ElementResult>& elements, const std::function<std::string(const std::string& uri)>& resolve);

/// In proportion to the time that the tasks take, roughly: the time spreads much less than the files' sizes.
std::vector<double> expectedCosts(const std::vector<MeshTask>& tasks);

/// Throws kFileNotFound if a task's file changed since its sha256 was computed: the cache would keep the result under a wrong key.
void expectUnchanged(const MeshTask& task);

/// Marks an element as failed and drops its hulls. `error` is the name of an ErrorCode.
void fail(ElementResult& element, const std::string& error, const std::string& reason);

/// The same for the exception being handled; rethrows kCancelled.
void fail(ElementResult& element);

}  // namespace collision_hulls
