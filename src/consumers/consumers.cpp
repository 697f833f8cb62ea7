// Which consumers there are, and what each asks of the mesh files.
#include "collision_hulls/consumers/consumers.h"

#include <algorithm>
#include <array>

#include "base/parallel.h"
#include "collision_hulls/error.h"
#include "collision_hulls/report/totals.h"
#include "consumers/written_model.h"
#include "pipeline/collision_model.h"

namespace collision_hulls {
namespace {

struct Entry {
  Consumer consumer;
  const char* name;
};

constexpr std::array<Entry, 9> kConsumers = {{{Consumer::kMoveit, "moveit"},
                                              {Consumer::kGazebo, "gazebo"},
                                              {Consumer::kMujoco, "mujoco"},
                                              {Consumer::kDrake, "drake"},
                                              {Consumer::kIsaac, "isaac"},
                                              {Consumer::kTesseract, "tesseract"},
                                              {Consumer::kCurobo, "curobo"},
                                              {Consumer::kDart, "dart"},
                                              {Consumer::kBullet, "bullet"}}};

bool takesPairs(Consumer consumer) {
  return consumer == Consumer::kMoveit || consumer == Consumer::kMujoco || consumer == Consumer::kCurobo;
}

ConsumerFiles filesFor(Consumer consumer, const WrittenModel& model, const std::vector<DisabledPair>& pairs, const RunControl& control) {
  switch (consumer) {
    case Consumer::kMoveit: return moveitFiles(model, pairs);
    case Consumer::kGazebo: return gazeboFiles(model);
    case Consumer::kMujoco: return mujocoFiles(model, pairs, control);
    case Consumer::kDrake: return drakeFiles(model);
    case Consumer::kIsaac: return isaacFiles(model);
    case Consumer::kTesseract: return tesseractFiles(model);
    case Consumer::kCurobo: return curoboFiles(model, pairs);
    case Consumer::kDart: return dartFiles(model);
    case Consumer::kBullet: return {};
  }
  return {};
}

void refuseFormat(Consumer consumer, MeshFormat format, const std::string& reads) {
  throw Error(ErrorCode::kBadOption, std::string("--for ") + name(consumer) + " does not go with format '" + (extension(format) + 1) +
                                         "': it reads " + reads + "; leave the format out");
}

/// Refuses a model, beside the first, whose description would take the place of the consumer's.
void refuseModel(Consumer consumer, const Options& options) {
  if (consumer != Consumer::kDrake && consumer != Consumer::kTesseract) return;
  for (std::size_t i = 1; i < options.models.size(); ++i)
    if (options.models[i].name == name(consumer))
      throw Error(ErrorCode::kBadOption, "model '" + options.models[i].name + "': --for " + name(consumer) +
                                             " writes a description of that name; give the model another one");
}

/// What has to be known of a consumer's files, or in place of them.
std::vector<std::string> notesFor(Consumer consumer, const WrittenModel& model, const std::string& output) {
  if (consumer == Consumer::kMujoco) return mujocoNotes(model);
  if (consumer == Consumer::kGazebo) return gazeboNotes(model);
  if (consumer == Consumer::kDart) return dartNotes(model);
  if (consumer == Consumer::kIsaac) return isaacNotes(model);
  if (consumer == Consumer::kBullet) return bulletNotes(model, output);
  return {};
}

}  // namespace

const char* name(Consumer consumer) {
  return std::find_if(kConsumers.begin(), kConsumers.end(), [&](const Entry& entry) { return entry.consumer == consumer; })->name;
}

std::optional<Consumer> consumerNamed(const std::string& name) {
  const auto found = std::find_if(kConsumers.begin(), kConsumers.end(), [&](const Entry& entry) { return entry.name == name; });
  return found == kConsumers.end() ? std::nullopt : std::optional<Consumer>(found->consumer);
}

std::string consumerChoices() {
  std::string names;
  for (const Entry& entry : kConsumers) names += (names.empty() ? "" : ", ") + std::string(entry.name);
  return names;
}

MeshFormat formatFor(const std::vector<Consumer>& consumers, MeshFormat usual) {
  return std::count(consumers.begin(), consumers.end(), Consumer::kDrake) > 0 ? MeshFormat::kObj : usual;
}

Shapes shapesFor(const std::vector<Consumer>& consumers, Shapes usual) {
  return std::count(consumers.begin(), consumers.end(), Consumer::kCurobo) > 0 ? Shapes::kSpheres : usual;
}

void check(const std::vector<Consumer>& consumers, const Options& options) {
  for (const Consumer consumer : consumers) {
    refuseModel(consumer, options);
    if (consumer == Consumer::kMujoco && options.format == MeshFormat::kDae) refuseFormat(consumer, options.format, "stl and obj");
    if (consumer == Consumer::kDrake && options.format != MeshFormat::kObj) refuseFormat(consumer, options.format, "obj alone");
    if (consumer == Consumer::kCurobo && options.shapes != Shapes::kSpheres)
      throw Error(ErrorCode::kBadOption, std::string("--for curobo does not go with shapes '") + name(options.shapes) +
                                             "': it takes spheres alone; leave the shapes out");
    if (consumer == Consumer::kBullet && options.uri == UriStyle::kFile)
      throw Error(ErrorCode::kBadOption, "--for bullet does not go with uri 'file': its importer does not know file://; leave it out");
  }
}

void check(const std::vector<Consumer>& consumers, const Options& options, const RobotDescription& robot, const RunControl& control) {
  if (std::count(consumers.begin(), consumers.end(), Consumer::kCurobo) > 0) checkForCurobo(robot, options, control);
}

void addConsumerFiles(const std::vector<Consumer>& consumers, const std::string& output, RobotResult& result, const RunControl& control,
                      const StepCallback& step) {
  if (consumers.empty()) return;
  check(consumers, result.report.options);
  if (result.single_mesh)
    throw Error(ErrorCode::kBadOption, std::string("--for ") + name(consumers.front()) + ": '" + result.robot_name +
                                           "' is a mesh, and only a robot's description has a form for it; leave the option out");
  withJobs(result.report.options.jobs, [&] {
    const WrittenModel model(result, outputPackage(result.report.options, output), control);
    std::vector<DisabledPair> pairs;
    if (std::any_of(consumers.begin(), consumers.end(), takesPairs)) {
      const std::size_t meshes = result.elements.size();
      if (step) step({"pairs", "", meshes, meshes, totals(result.report).hulls, 1, -1});
      pairs = pairsWithoutCheck(model, control);
    }
    std::vector<std::string>& notes = result.report.notes;
    const auto add = [&](const std::vector<std::string>& more) {
      for (const std::string& note : more)
        if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(note);
    };
    add(notesOn(pairs));
    for (const Consumer consumer : consumers) {
      for (auto& [file, text] : filesFor(consumer, model, pairs, control)) result.extra_files[file] = text;
      add(notesFor(consumer, model, output));
    }
  });
}

}  // namespace collision_hulls
