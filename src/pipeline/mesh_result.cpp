// Failures: an exception becomes the row of a mesh, so that it costs the run nothing else.
#include "pipeline/mesh_result.h"

#include <new>

#include "collision_hulls/error.h"

namespace collision_hulls {

void fail(MeshResult& result, const std::string& error, const std::string& reason) {
  result.hulls.clear();
  result.primitives.clear();
  result.unneeded.clear();
  result.model = {};
  result.status = Status::kFailed;
  result.error = error;
  result.reason = reason;
}

void fail(MeshResult& result) {
  try {
    throw;
  } catch (const Error& e) {
    if (e.code() == ErrorCode::kCancelled) throw;
    fail(result, name(e.code()), e.what());
  } catch (const std::bad_alloc&) {
    fail(result, name(ErrorCode::kOutOfMemory),
         "out of memory for a mesh of " + std::to_string(result.mesh.triangles) +
             " triangles; use fewer jobs, a larger tolerance or a coarser mesh");
  } catch (const std::exception& e) {
    fail(result, name(ErrorCode::kInternal), e.what());
  }
}

}  // namespace collision_hulls
