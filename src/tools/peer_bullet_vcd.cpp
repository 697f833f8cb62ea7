// peer_bullet_vcd in.obj out.obj tolerance: runs Bullet's ConvexDecomposition, for comparison. As of Bullet 3.24 the library divides meshes
// by a plane that it never sets (valgrind: planeTriIntersection depends on an uninitialised value), so its results vary with memory
// addresses and hardly respond to any parameter.
#include <ConvexDecomposition/ConvexBuilder.h>
#include <sys/personality.h>
#include <unistd.h>

#include "collision_hulls/geometry/triangle_mesh.h"
#include "peer_program.h"

namespace collision_hulls {
namespace {

constexpr const char* kHelp =
    "Decomposes a mesh with ConvexDecomposition from Bullet's extras, which halves it while the volume between surface and hull\n"
    "exceeds a share of the first hull's, and merges halves whose common hull has little more volume. The library ignores\n"
    "concavities below 0.05 of its units: the mesh is scaled so that this equals the tolerance (metres). Both shares are\n"
    "tolerance / diagonal of the bounding box. At most 8 levels of halving and 64 vertices per hull.\n"
    "As of Bullet 3.24 the library halves by a plane that it never sets, so results vary with memory addresses; this program\n"
    "therefore disables address space randomization for itself.\n";

constexpr double kConcavityThreshold = 0.05;  // the library's own
constexpr unsigned kDepth = 8, kMostVertices = 64;

class Collected : public ConvexDecomposition::ConvexDecompInterface {
 public:
  explicit Collected(double scale) : scale_(scale) {}

  void ConvexDecompResult(ConvexDecomposition::ConvexResult& hull) override {
    TriangleMesh part;
    for (unsigned v = 0; v < hull.mHullVcount; ++v) {
      const float* const p = hull.mHullVertices + 3 * v;
      part.vertices.push_back(Eigen::Vector3d(p[0], p[1], p[2]) / scale_);
    }
    for (unsigned t = 0; t < hull.mHullTcount; ++t) {
      const unsigned* const corners = hull.mHullIndices + 3 * t;
      part.triangles.push_back({static_cast<int>(corners[0]), static_cast<int>(corners[1]), static_cast<int>(corners[2])});
    }
    parts.push_back(part);
  }

  std::vector<TriangleMesh> parts;

 private:
  double scale_;
};

std::vector<TriangleMesh> decompose(const TriangleMesh& mesh, double tolerance) {
  const double scale = kConcavityThreshold / tolerance;
  std::vector<float> vertices;
  for (const Eigen::Vector3d& v : mesh.vertices)
    for (const double x : {v.x(), v.y(), v.z()}) vertices.push_back(static_cast<float>(scale * x));
  std::vector<unsigned> indices;
  for (const Triangle& t : mesh.triangles)
    for (const int corner : t) indices.push_back(static_cast<unsigned>(corner));

  Collected collected(scale);
  ConvexDecomposition::DecompDesc options;
  options.mVcount = static_cast<unsigned>(mesh.vertices.size());
  options.mVertices = vertices.data();
  options.mTcount = static_cast<unsigned>(mesh.triangles.size());
  options.mIndices = indices.data();
  options.mDepth = kDepth;
  options.mCpercent = static_cast<float>(100 * tolerance / diagonal(mesh));
  options.mPpercent = options.mCpercent;
  options.mMaxVertices = kMostVertices;
  options.mSkinWidth = 0;
  options.mCallback = &collected;
  ConvexBuilder(&collected).process(options);
  return collected.parts;
}

constexpr unsigned long kAskAlone = 0xffffffff;

/// Restarts the program without address space randomization, if the system allows it.
void fixAddresses(char** argv) {
  const int now = personality(kAskAlone);
  if (now != -1 && !(now & ADDR_NO_RANDOMIZE) && personality(static_cast<unsigned long>(now) | ADDR_NO_RANDOMIZE) != -1)
    execv("/proc/self/exe", argv);
}

}  // namespace
}  // namespace collision_hulls

int main(int argc, char** argv) {
  collision_hulls::fixAddresses(argv);
  return collision_hulls::peerMain(argc, argv, collision_hulls::kHelp, collision_hulls::decompose);
}
