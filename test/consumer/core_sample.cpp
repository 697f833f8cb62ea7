// Uses collision_hulls_core alone: how far do the hulls of a mesh protrude at 5 mm?
#include <collision_hulls/decompose/decompose.h>
#include <collision_hulls/measure/measures.h>
#include <collision_hulls/mesh/mesh_io.h>

#include <iostream>

int main(int argc, char** argv) try {
  using namespace collision_hulls;
  if (argc < 2) return 2;
  const RepairedMesh mesh = repair(readMesh(argv[1]).mesh);
  DecomposeOptions options;
  options.tolerance = 0.005;
  const Decomposition result = decompose(mesh, options);
  const double bound = protrusion(result.hulls, Solid(mesh), 1e-5).bound;
  std::cout << result.hulls.size() << " hulls, protrusion at most " << bound << " m\n";
  return bound <= 0.006 ? 0 : 1;
} catch (const collision_hulls::Error& error) {
  std::cerr << error.what() << '\n';
  return 2;
}
