// The extension module collision_hulls._core: arrays in, arrays out. src/python/collision_hulls/__init__.py is its only user, and has the
// interface that people see: names, defaults, type hints, documentation, checks of the arrays.
//
// Options come as the words of a command line and are parsed by what parses those of `decompose`: the same names, checks and messages, and
// no option that the programs have and Python lacks. __init__.py puts Python's keywords into the messages.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/at.h"
#include "base/parallel.h"
#include "collision_hulls/decompose/certified_hulls.h"
#include "collision_hulls/mesh/openings.h"
#include "collision_hulls/report/report.h"
#include "interruptible.h"
#include "mesh/polygons.h"
#include "pipeline/stages.h"
#include "tools/scene_command.h"

namespace collision_hulls {
namespace {

namespace py = pybind11;

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Indices = py::array_t<int, py::array::c_style | py::array::forcecast>;
using Words = std::vector<std::string>;

/// Fills what the options of `app` fill.
void parse(CommandLine& app, const Words& words) {
  std::vector<const char*> arguments{app.get_name().c_str()};
  for (const std::string& word : words) arguments.push_back(word.c_str());
  app.parse(static_cast<int>(arguments.size()), arguments.data());
}

/// The mesh with its vertices in the order of their first use, as a reader gives it. Indices must be in range.
TriangleMesh meshOf(const Numbers& vertices, const Indices& faces) {
  TriangleMesh mesh;
  const auto from = vertices.unchecked<2>();
  const auto corners = faces.unchecked<2>();
  std::vector<int> number(at(from.shape(0)), -1);
  for (py::ssize_t f = 0; f < corners.shape(0); ++f) {
    Triangle triangle{};
    for (py::ssize_t k = 0; k < 3; ++k) {
      const py::ssize_t v = corners(f, k);
      int& mine = number[at(v)];
      if (mine < 0) {
        mine = static_cast<int>(mesh.vertices.size());
        mesh.vertices.emplace_back(from(v, 0), from(v, 1), from(v, 2));
      }
      triangle[at(k)] = mine;
    }
    mesh.triangles.push_back(triangle);
  }
  return mesh;
}

/// The stages of `decompose` for one mesh, with the margin of a mesh that was read from a file: the same hulls.
CertifiedHulls hullsOf(const TriangleMesh& given, double close_openings, const DecomposeOptions& options, const RunControl& control) {
  const TriangleMesh mesh = close_openings > 0 ? closeOpenings(given, close_openings, control) : given;
  double largest = 0;
  for (const Eigen::Vector3d& v : mesh.vertices) largest = std::max(largest, v.cwiseAbs().maxCoeff());
  const double resolution = singlePrecisionResolution(mesh, largest, "vertices");
  const RepairedMesh repaired = repair(mesh, {}, control);
  const Solid solid(repaired, control);
  return certifiedHulls({mesh, repaired, solid, readingError(resolution) + repaired.counts.weld_distance, nullptr, ""}, options, control);
}

/// A copy as an array of rows of three.
template <typename Number, typename Rows>
py::array_t<Number> arrayOf(const Rows& rows) {
  py::array_t<Number> array({static_cast<py::ssize_t>(rows.size()), py::ssize_t{3}});
  auto to = array.template mutable_unchecked<2>();
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) to(static_cast<py::ssize_t>(i), static_cast<py::ssize_t>(k)) = rows[i][static_cast<int>(k)];
  return array;
}

py::array_t<double> arrayOf(const Eigen::Vector3d& p) {
  return py::array_t<double>(3, p.data());
}

/// The fields of the Python class Result; its hulls as tuples of the fields of Hull.
py::dict fieldsOf(const CertifiedHulls& made, const DecomposeOptions& options) {
  py::list hulls;
  for (const ConvexHull& hull : made.hulls)
    hulls.append(py::make_tuple(arrayOf<double>(hull.vertices), arrayOf<int>(hull.triangles), volume(hull)));
  py::dict fields;
  fields["hulls"] = hulls;
  fields["bound"] = made.bound;
  fields["found"] = made.found;
  fields["where"] = arrayOf(made.where);
  fields["nearest"] = arrayOf(made.nearest);
  fields["tolerance"] = options.tolerance;
  fields["status"] = name(made.within_tolerance ? Status::kOk : Status::kDegraded);
  fields["reason"] = made.reason;
  fields["least_hulls"] = made.least_hulls;
  return fields;
}

Options optionsOf(const Words& words) {
  RobotCommand command;
  CommandLine app("", "decompose");
  DecomposeOptionAdder(app, command.given).addAll();
  parse(app, words);
  command.given.apply(command.options);
  checkCommand(command);
  return command.options;
}

/// What an array's mesh takes of the options of a run.
DecomposeOptions optionsFor(const TriangleMesh& mesh, const Options& options) {
  checkSize("the mesh", diagonal(mesh), options.tolerance, "multiply its vertices by 0.001");
  return {options.method,    toleranceFor(mesh, options.tolerance),
          options.max_hulls, options.max_vertices,
          options.seed,      options.effort,
          options.fill,      {},
          options.padding};
}

py::dict decomposeArrays(const Numbers& vertices, const Indices& faces, const Words& words, const py::object& look) {
  const Options options = optionsOf(words);
  const TriangleMesh mesh = meshOf(vertices, faces);
  const DecomposeOptions how = optionsFor(mesh, options);
  CertifiedHulls made;
  const auto work = [&](const RunControl& control) {
    withJobs(options.jobs, [&] { made = hullsOf(mesh, options.close_openings, how, control); });
  };
  runInterruptibly(work, look);
  return fieldsOf(made, how);
}

/// A run in which every mesh failed: why, and the name of the first failure's ErrorCode.
struct NothingMade {
  std::string text, error;
};

/// Writes a result. Throws NothingMade.
void write(MadeRobot& made, const RobotCommand& command, const RunControl& control) {
  if (writeOutputAndReport(made.result, command, made.output, control)) return;
  const std::vector<ElementReport>& rows = made.result.report.links;
  const auto first = std::find_if(rows.begin(), rows.end(), [](const ElementReport& row) { return row.status == Status::kFailed; });
  NothingMade nothing{"no mesh could be decomposed; nothing was written to '" + made.output + "'", first->error};
  for (const std::string& failure : failures(made.result.report)) nothing.text += "\n" + failure;
  throw nothing;
}

/// A program's command line, and what it makes.
struct Program {
  explicit Program(const std::string& name) : app("", name), fits(name == "fit_scene") {
    command.program = name;
    if (fits) {
      addSceneOptions(app, scene);
    } else {
      addRobotOptions(app, "", command);
      addModelOption(app, command);
    }
  }

  SceneCommand scene;
  RobotCommand& command = scene.robot;
  CommandLine app;
  const bool fits;
};

/// The options of a program by name: whether they take a value, and whether they may take several.
std::map<std::string, std::pair<bool, bool>> knownOptions(const std::string& program) {
  return Program(program).app.takesValue();
}

/// Runs a program; the text of report.json.
std::string reportOf(const std::string& program, const Words& words, const py::object& look) {
  Program called(program);
  RobotCommand& command = called.command;
  parse(called.app, words);
  command.quiet = true;
  if (called.fits) interpret(called.scene);
  const RobotWork decomposing = [&](const Input& input, const std::string& output, const RunControl& run, const StepCallback& step) {
    return decompose(input, command.options, output, run, step);
  };
  std::string report;
  const auto work = [&](const RunControl& control) {
    std::optional<Confinement> confinement;
    confine(command, confinement);
    MadeRobot made =
        make(command, called.fits ? fitting(called.scene) : decomposing, control, [&](const Step& step) { control.report(step.fraction); });
    write(made, command, control);
    writeComparison(called.scene);
    report = toJson(made.result.report);
  };
  runInterruptibly(work, look);
  return report;
}

/// The text goes as bytes, since the names of files in it may be no UTF-8.
void raise(const std::string& text, const std::string& name) {
  const py::object error = py::module::import("collision_hulls").attr("_error")(py::bytes(text), name);
  PyErr_SetObject(error.get_type().ptr(), error.ptr());
}

/// What is thrown here becomes collision_hulls.Error.
void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const Error& error) {
    raise(error.what(), name(error.code()));
  } catch (const NothingMade& nothing) {
    raise(nothing.text, nothing.error);
  }
}

}  // namespace
}  // namespace collision_hulls

PYBIND11_MODULE(_core, module) {
  namespace py = pybind11;
  module.doc() = "The library's side of the package collision_hulls, which checks arguments and documents them.";
  py::register_exception_translator(collision_hulls::translate);
  module.def("decompose", collision_hulls::decomposeArrays, py::arg("vertices"), py::arg("faces"), py::arg("words"), py::arg("look"));
  module.def("options", collision_hulls::knownOptions, py::arg("program"));
  module.def("version", collision_hulls::version);
  module.def("run", collision_hulls::reportOf, py::arg("program"), py::arg("words"), py::arg("look"));
}
