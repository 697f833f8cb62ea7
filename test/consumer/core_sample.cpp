// Uses collision_hulls_core alone: how far do the hulls of a mesh protrude at 5 mm?
#include <collision_hulls/decompose/certified_hulls.h>
#include <collision_hulls/mesh/mesh_io.h>

#include <iostream>

int main(int argc, char** argv) try {
  using namespace collision_hulls;
  if (argc < 2) return 2;
  DecomposeOptions options;
  options.tolerance = 0.005;  // [m]
  const CertifiedHulls result = certifiedHulls(readMesh(argv[1]).mesh, options);
  std::cout << result.hulls.size() << " hulls protrude by at most " << result.bound << " m\n";
  return result.within_tolerance ? 0 : 1;
} catch (const collision_hulls::Error& error) {
  std::cerr << error.what() << '\n';
  return 2;
}
