// FCL sees only surfaces, so a body inside another would count as far away. Hence one point per component is also tested against the other
// body's solid: if the surfaces do not touch, a component is inside either entirely or not at all.
#include "fit/originals.h"

#include <algorithm>
#include <map>
#include <variant>

#include "mesh/loose_segments.h"

namespace collision_hulls {
namespace {

using Body = Originals::Body;

bool holds(const Body& body, const Eigen::Vector3d& p) {
  if (!body.body.box().contains(p)) return false;
  if (body.convex) return planeDistance(*body.convex, p) <= 0;
  return body.solid && body.solid->contains(p);
}

/// Whether a component of `inner` lies inside `outer`, given that they do not touch; `pose` is that of `inner` in the frame of `outer`.
bool within(const Body& inner, const Body& outer, const Eigen::Isometry3d& pose) {
  return std::any_of(inner.points.begin(), inner.points.end(), [&](const Eigen::Vector3d& p) { return holds(outer, pose * p); });
}

Body bodyOf(const ConvexHull& hull, const QueryBody& body, const RunControl&) {
  return {body, Eigen::Isometry3d::Identity(), nullptr, &hull, {hull.vertices.front()}};
}

Body bodyOf(const TriangleMesh& mesh, const QueryBody& body, const RunControl& control) {
  return {body, Eigen::Isometry3d::Identity(), nullptr, nullptr, pointsOfComponents(repair(mesh, {}, control))};
}

}  // namespace

Originals::Originals(const FitProblem& problem, const Assembly& assembly, const RunControl& control) : of_part_(assembly.parts()) {
  std::map<const FitMesh*, QueryBody> meshes;
  for (const FitElement& element : problem.elements) {
    const FitMesh& mesh = *element.mesh;
    const QueryBody& body = meshes.try_emplace(&mesh, mesh.original, control).first->second;
    of_part_[element.link].push_back({body, element.origin, mesh.solid.get(), nullptr, mesh.solid->componentPoints()});
  }
  std::size_t piece = problem.elements.size();  // of the bodies that are in the model as well
  const auto add = [&](std::size_t part, const auto& body) {
    const DetailTree& tree = *assembly.pieces()[piece++].tree;
    of_part_[part].push_back(std::visit([&](const auto& shape) { return bodyOf(shape, tree.body(tree.root()), control); }, body.shape));
  };
  for (const KeptBody& kept : problem.kept) add(kept.link, kept);
  for (std::size_t i = 0; i < problem.scene.bodies.size(); ++i) add(assembly.links() + i, problem.scene.bodies[i]);
}

bool Originals::touch(std::size_t a, std::size_t b, const Places& places) const {
  for (const Body& first : of_part_[a]) {
    const Eigen::Isometry3d to_first = (places[a] * first.origin).inverse() * places[b];
    for (const Body& second : of_part_[b]) {
      const Eigen::Isometry3d pose = to_first * second.origin;
      if (!apart(first.body.box(), second.body.box(), pose) && collision_hulls::touch(first.body, second.body, pose)) return true;
    }
  }
  return false;
}

double Originals::distanceBelow(double limit, std::size_t a, std::size_t b, const Places& places) const {
  double least = limit;
  for (const Body& first : of_part_[a]) {
    const Eigen::Isometry3d to_first = (places[a] * first.origin).inverse() * places[b];
    for (const Body& second : of_part_[b]) {
      const Eigen::Isometry3d pose = to_first * second.origin;
      if (first.body.box().exteriorDistance(placed(second.body.box(), pose)) >= least) continue;
      if (within(second, first, pose) || within(first, second, pose.inverse())) return 0;
      least = collision_hulls::distanceBelow(least, first.body, second.body, pose);
      if (least <= 0) return 0;
    }
  }
  return least;
}

std::vector<Eigen::AlignedBox3d> Originals::boxesOfLinks(const Places& places) const {
  std::vector<Eigen::AlignedBox3d> boxes(places.links().size());
  for (std::size_t link = 0; link < boxes.size(); ++link)
    for (const Body& body : of_part_[link]) boxes[link].extend(placed(body.body.box(), places[link] * body.origin));
  return boxes;
}

bool Originals::contains(std::size_t outer, std::size_t inner, const Places& places) const {
  for (const Body& first : of_part_[outer]) {
    const Eigen::Isometry3d to_first = (places[outer] * first.origin).inverse() * places[inner];
    for (const Body& second : of_part_[inner])
      if (within(second, first, to_first * second.origin)) return true;
  }
  return false;
}

}  // namespace collision_hulls
