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

/// What a run on a robot begins with: an element for every mesh of every chosen link, in document order: who and where it is, nothing
/// computed yet.
RobotResult robotResult(const RobotDescription& robot, const Options& options);

/// Says so where there is no mesh among the elements that Options::source takes, and which others have some.
std::vector<std::string> notesOnElements(const RobotDescription& robot, const std::vector<ElementResult>& elements, const Options& options);

/// A mesh to work on, and the elements (indices) that it is worked on for: same content, kind of file and scale.
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

/// Throws kFileNotFound where a task's file is no longer the one that its sha256 was taken of: its result would stand under a wrong name.
void expectUnchanged(const MeshTask& task);

/// Marks an element as failed, by an error's name; hulls that it has are none of the result.
void fail(ElementResult& element, const std::string& error, const std::string& reason);

/// The same for the exception that is being handled; throws it again where it is kCancelled.
void fail(ElementResult& element);

}  // namespace collision_hulls
