// Reads a mesh's bytes in a process of its own: both ends of the questions that the library asks the program collision_hulls_reader.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "collision_hulls/mesh/mesh_io.h"
#include "mesh/formats/gltf_container.h"
#include "sandbox/serve.h"

namespace collision_hulls {

/// The library's end: a mesh that was decoded in a worker, checked again. Throws what parseMesh() throws.
LoadedMesh decodeInWorker(const std::string& bytes, const std::string& name, const MeshLimits& limits, const RunControl& control);

/// The files that hold buffers of a .gltf file, each once; `bytes` are that file's alone. Throws what decodeInWorker() throws. The URIs are
/// foreign, and not looked at.
std::vector<BufferFile> askForBufferFiles(const std::string& bytes, const std::string& name, const MeshLimits& limits,
                                          const RunControl& control);

/// The mesh in an answer, which is believed nothing: throws kReaderFailed for numbers that no mesh within the limits has.
LoadedMesh meshIn(const std::string& answer, const std::string& name, const MeshLimits& limits);

/// The files in an answer. Throws kReaderFailed.
std::vector<BufferFile> bufferFilesIn(const std::string& answer, const std::string& name);

/// Takes a file's bytes and name, limits, and what may end it: decodeMesh() of the room decode.
using MeshDecoder = std::function<LoadedMesh(const std::string&, const std::string&, const MeshLimits&, const RunControl&)>;

/// The worker's ends.
std::string answerMeshQuestion(const Question& question, const MeshDecoder& decode);
std::string answerBufferQuestion(const Question& question);

}  // namespace collision_hulls
