// Also tests src/pipeline/notes/hull_notes.cpp.
#include "pipeline/rows.h"

#include <gtest/gtest.h>

#include "shapes.h"

namespace collision_hulls {
namespace {

using Files = std::vector<std::string>;

MeshUse use(const std::string& link, int element = 0) {
  MeshUse use;
  use.link = link;
  use.element = element;
  use.source.uri = link + ".stl";
  use.source.scale = {1, 2, 3};
  return use;
}

MeshResult boxes(std::size_t count) {
  MeshResult result;
  result.mesh.sha256 = "abc";
  result.mesh.diagonal = 1;
  result.mesh.tolerance = 0.01;
  result.model.protrusion = 0.005;
  result.status = Status::kDegraded;
  result.reason = "why";
  result.seconds.decompose = 7;
  result.model.hulls = count;
  result.hulls.assign(count, convexHull(test_shapes::box(1, 1, 1).vertices));
  return result;
}

std::shared_ptr<const MeshResult> shared(MeshResult result) {
  return std::make_shared<const MeshResult>(std::move(result));
}

TEST(PutTogether, OfNothing) {
  RobotResult result;
  putTogether({}, {}, result);
  EXPECT_TRUE(result.report.links.empty() && result.elements.empty() && result.report.notes.empty());
}

TEST(PutTogether, ARowHasItsUseItsResultAndItsFiles) {
  RobotResult result;
  MeshUse used = use("arm", 2);
  used.options.method = Method::kAcd;
  putTogether({used}, {shared(boxes(2))}, result);
  const ElementReport& row = result.report.links.at(0);
  EXPECT_EQ(row.link, "arm");
  EXPECT_EQ(row.element, 2);
  EXPECT_EQ(row.uri, "arm.stl");
  EXPECT_EQ(row.scale, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(row.method, Method::kAcd);
  EXPECT_EQ(row.sha256, "abc");
  EXPECT_EQ(row.protrusion, 0.005);
  EXPECT_EQ(row.status, Status::kDegraded);
  EXPECT_EQ(row.reason, "why");
  EXPECT_EQ(row.files, (Files{"meshes/arm/2_0.stl", "meshes/arm/2_1.stl"}));
  EXPECT_EQ(result.elements.at(0).link, "arm");
  EXPECT_EQ(result.elements.at(0).hulls.size(), 2u);
}

TEST(PutTogether, TheTimeOfASharedMeshCountsOnce) {
  RobotResult result;
  const auto mesh = shared(boxes(1));
  putTogether({use("a"), use("b"), use("c")}, {mesh, shared(boxes(1)), mesh}, result);
  const std::vector<ElementReport>& rows = result.report.links;
  EXPECT_EQ(rows[0].seconds.decompose, 7);
  EXPECT_EQ(rows[1].seconds.decompose, 7) << "an equal mesh, but worked on by itself";
  EXPECT_EQ(rows[2].seconds.decompose, 0);
}

TEST(PutTogether, PrimitivesHaveNoFiles) {
  RobotResult result;
  MeshResult mesh = boxes(3);
  mesh.primitives.resize(2);
  putTogether({use("arm")}, {shared(std::move(mesh))}, result);
  EXPECT_EQ(result.report.links[0].files, Files{"meshes/arm/0_0.stl"});
}

TEST(PutTogether, ASingleMeshHasAFileOfAllHullsFirst) {
  RobotResult result;
  result.single_mesh = true;
  result.robot_name = "my part";
  putTogether({use("my part")}, {shared(boxes(1))}, result);
  EXPECT_EQ(result.report.links[0].files, (Files{"my_part_hulls.obj", "hull_0.stl"}));
  RobotResult failed;
  failed.single_mesh = true;
  putTogether({use("part")}, {shared(boxes(0))}, failed);
  EXPECT_TRUE(failed.report.links[0].files.empty());
}

TEST(PutTogether, ModelsShareEqualHullsOfAnElement) {
  RobotResult result;
  result.report.options.models = {{"planning", lengthOf(0.01)}, {"contact", lengthOf(0.001)}};
  result.report.models.resize(1);
  result.models.resize(1);
  MeshUse fine = use("a");
  fine.model = 1;
  MeshResult finer = boxes(1);
  finer.hulls.push_back(convexHull(test_shapes::box(1, 1, 2).vertices));
  putTogether({use("a"), fine}, {shared(boxes(1)), shared(finer)}, result);
  EXPECT_EQ(result.report.links.at(0).files, Files{"meshes/a/0_0.stl"});
  EXPECT_EQ(result.report.models[0].links.at(0).files, (Files{"meshes/a/0_0.stl", "meshes/a/contact_0_1.stl"}));
  EXPECT_EQ(result.models[0].elements.at(0).hulls.size(), 2u);
}

TEST(PutTogether, NotesMeshesThatALengthAloneMakesCoarser) {
  MeshResult large = boxes(1), small = boxes(1), smaller = boxes(1), failed = boxes(0), other = boxes(1);
  for (MeshResult* mesh : {&large, &small, &smaller, &failed}) mesh->mesh.tolerance = 0.005;
  large.mesh.diagonal = 0.1;  // 5 % of it is the tolerance
  small.mesh.diagonal = 0.08;
  smaller.mesh.diagonal = other.mesh.diagonal = 0.04;
  failed.status = Status::kFailed;
  other.mesh.tolerance = 0.003;  // by a rule of its own
  const auto notes = [&](const Length& tolerance) {
    RobotResult result;
    result.report.options.tolerance = tolerance;
    putTogether({use("a"), use("b"), use("c"), use("d"), use("e")},
                {shared(large), shared(small), shared(smaller), shared(failed), shared(other)}, result);
    return result.report.notes;
  };
  EXPECT_EQ(notes(lengthOf(0.005)),
            std::vector<std::string>{"a tolerance of 5mm is coarser than the default for 2 small meshes, such as 'c.stl' "
                                     "(2 mm by default): '5mm,5%' is at least as fine for all"});
  EXPECT_TRUE(notes({0.005, 0.5}).empty()) << "the share was chosen";
  large.mesh.tolerance = small.mesh.tolerance = smaller.mesh.tolerance = 0.02;
  EXPECT_TRUE(notes(lengthOf(0.02)).empty()) << "coarse on purpose";
}

TEST(PutTogether, NotesMeshesOfVeryManyHulls) {
  const auto notes = [](std::size_t first, std::size_t second, bool fits) {
    RobotResult result;
    if (fits) result.report.scene.emplace();
    putTogether({use("a"), use("b")}, {shared(boxes(first)), shared(boxes(second))}, result);
    return result.report.notes;
  };
  EXPECT_TRUE(notes(39, 39, false).empty());
  EXPECT_EQ(notes(40, 39, false),
            std::vector<std::string>{"'a.stl' took 40 hulls at a tolerance of 10 mm: a larger tolerance makes fewer, also for single links "
                                     "('links: {a: {tolerance: 2cm}}' in a configuration); so does a limit, as in --max-hulls 16"});
  EXPECT_EQ(notes(41, 42, false).at(0).find("'b.stl' took 42 hulls at a tolerance of 10 mm; 1 other mesh is like it: "), 0u);
  EXPECT_TRUE(notes(101, 100, true).empty()) << "a fit to a scene chose them";
  for (const bool single_mesh : {true, false}) {
    RobotResult result;
    result.single_mesh = single_mesh;
    result.robot_name = "part";
    putTogether({use(single_mesh ? "a" : "a.b")}, {shared(boxes(40))}, result);
    EXPECT_NE(result.report.notes.at(0).find("makes fewer; so"), std::string::npos) << "no link, or a name to be quoted";
  }
  MeshUse with_region = use("a");
  with_region.options.regions = {boxRegion({1, 1, 1}, Eigen::Isometry3d::Identity(), 0.02),
                                 boxRegion({1, 1, 1}, Eigen::Isometry3d::Identity(), 0.001)};
  with_region.options.regions[0].name = "coarse";
  with_region.options.regions[1].name = "fine";
  RobotResult result;
  putTogether({with_region}, {shared(boxes(101))}, result);
  EXPECT_EQ(result.report.notes.at(0),
            "'a.stl' took 101 hulls at a tolerance of 10 mm and, in region 'fine', of 1 mm: a smaller region, or a larger tolerance in it, "
            "may make fewer; so does a limit, as in --max-hulls 16");
}

TEST(PutTogether, NotesVeryManyHullsInAll) {
  const auto notes = [](const std::vector<std::size_t>& counts) {
    std::vector<MeshUse> uses;
    MeshResults meshes;
    for (const std::size_t count : counts) {
      uses.push_back(use("link" + std::to_string(uses.size())));
      meshes.push_back(shared(boxes(count)));
    }
    RobotResult result;
    putTogether(uses, meshes, result);
    return result.report.notes;
  };
  const std::string all = "for fewer, give a larger tolerance, and for small parts a larger percentage with it, as in 3cm,20%; or ";
  std::vector<std::size_t> counts(14, 36);
  EXPECT_EQ(notes(counts),
            std::vector<std::string>{"14 meshes took 504 hulls: " + all + "limit the hulls of each mesh, as in --max-hulls 4"});
  counts.back() = 32;
  EXPECT_TRUE(notes(counts).empty()) << "500 in all";
  EXPECT_EQ(notes({501}).size(), 1u) << "its own note says it";
  const std::vector<std::string> both = notes({300, 201});
  ASSERT_EQ(both.size(), 2u);
  EXPECT_EQ(both[0].find("'link0.stl' took 300 hulls"), 0u) << both[0];
  EXPECT_EQ(both[1].find("2 meshes took 501 hulls: "), 0u) << both[1];
}

TEST(PutTogether, AMeshOfManyHullsHasOneNote) {
  MeshResult shell = boxes(105), detailed = boxes(104);
  shell.mesh.openings = 2;
  shell.mesh.widest_opening = 0.3;
  MeshResult loose = shell;
  loose.mesh.repair.components = 30;
  RobotResult result;
  putTogether({use("a"), use("b"), use("c")}, {shared(shell), shared(detailed), shared(loose)}, result);
  const std::vector<std::string>& notes = result.report.notes;
  ASSERT_EQ(notes.size(), 3u) << ::testing::PrintToString(notes);
  EXPECT_EQ(notes[0].find("'c.stl' consists of 30 loose parts and took 105 hulls: "), 0u) << notes[0];
  EXPECT_EQ(notes[1].find("'a.stl' has 2 openings and took 105 hulls: "), 0u) << notes[1];
  EXPECT_EQ(notes[2].find("'b.stl' took 104 hulls at a tolerance of 10 mm: "), 0u) << notes[2];
}

TEST(PutTogether, NothingIsKnownOfTheSizeOfKeptMeshes) {
  MeshResult kept;
  kept.status = Status::kKept;
  MeshUse scaled = use("a");
  scaled.source.scale = Eigen::Vector3d::Constant(0.001);
  RobotResult result;
  putTogether({scaled}, {shared(kept)}, result);
  EXPECT_TRUE(result.report.notes.empty()) << result.report.notes.front();
}

TEST(PutTogether, NotesMeshesThatTheLimitOnVerticesDivides) {
  MeshUse limited = use("a");
  const auto notes = [&](std::size_t hulls, std::size_t vertices, std::size_t least, int limit = 64) {
    MeshResult mesh = boxes(hulls);
    mesh.model.hull_vertices = vertices;
    mesh.model.least_hulls = least;
    limited.options.max_vertices = limit;
    RobotResult result;
    result.report.options.max_vertices = 8;  // of other links
    putTogether({limited}, {shared(mesh)}, result);
    return result.report.notes;
  };
  EXPECT_EQ(notes(4, 248, 1), std::vector<std::string>{"'a.stl' took 4 hulls with nearly as many vertices each as they may have (64): with "
                                                       "more, as in --max-vertices 256, or without a limit (0), far fewer may do"});
  EXPECT_TRUE(notes(4, 230, 1).empty()) << "the limit hardly matters";
  EXPECT_TRUE(notes(4, 248, 2).empty()) << "one would not do";
  EXPECT_TRUE(notes(3, 192, 1).empty()) << "there is little to gain";
  EXPECT_TRUE(notes(4, 248, 1, 0).empty()) << "there is no limit";
  limited.options.effort = Effort::kInstant;
  EXPECT_TRUE(notes(4, 248, 1).empty()) << "nobody looked for few hulls";
}

TEST(PutTogether, NotesMeshesOfManyLooseParts) {
  const auto notes = [](std::size_t parts, std::size_t hulls, std::size_t uses, std::size_t openings = 0) {
    MeshResult mesh = boxes(hulls);
    mesh.mesh.repair.components = parts;
    mesh.mesh.openings = openings;
    RobotResult result;
    putTogether({use("a"), use("b")}, {shared(mesh), shared(uses > 1 ? mesh : boxes(1))}, result);
    return result.report.notes;
  };
  EXPECT_TRUE(notes(19, 20, 1).empty());
  EXPECT_TRUE(notes(20, 19, 1).empty()) << "the parts cost little";
  EXPECT_EQ(notes(45, 36, 1),
            (std::vector<std::string>{"'a.stl' consists of 45 loose parts and took 36 hulls: remove parts that nothing can touch"}));
  EXPECT_EQ(notes(45, 36, 1, 2).at(0),
            "'a.stl' consists of 45 loose parts and took 36 hulls: if parts lie in a housing with openings, --close-openings makes it "
            "solid, and they take no hulls; or remove parts that nothing can touch");
  EXPECT_NE(notes(45, 36, 2).at(0).find("36 hulls; 1 other mesh is like it: "), std::string::npos);
}

/// Boxes side by side, and brackets.
TriangleMesh parts(int boxes, int brackets) {
  std::vector<TriangleMesh> all;
  for (int i = 0; i < boxes; ++i) all.push_back(test_shapes::moved(test_shapes::box(1, 1, 1), {2. * i, 0, 0}));
  for (int i = 0; i < brackets; ++i) all.push_back(test_shapes::moved(test_shapes::lBracket(), {2. * i, 5, 0}));
  return test_shapes::merged(all);
}

TEST(PutTogether, NotesMeshesThatConsistOfConvexPartsAlready) {
  const auto note = [](const TriangleMesh& original, std::size_t openings = 0, bool single_mesh = false) {
    MeshResult mesh = boxes(30);
    mesh.original = original;
    mesh.mesh.repair.components = 25;
    mesh.mesh.openings = openings;
    RobotResult result;
    result.single_mesh = single_mesh;
    putTogether({use("a")}, {shared(mesh)}, result);
    return result.report.notes.at(0);
  };
  EXPECT_EQ(note(parts(25, 0)),
            "'a.stl' already consists of 25 convex parts, and took 30 hulls: use it as it is ('keep' in a configuration), or give a larger "
            "tolerance for fewer hulls");
  EXPECT_EQ(note(parts(25, 1)).find("'a.stl' already consists of 25 convex parts and 1 other, and took 30 hulls: "), 0u);
  EXPECT_NE(note(parts(25, 0), 0, true).find(": use it as it is, or give"), std::string::npos) << "a mesh has no configuration";
  EXPECT_NE(note(parts(20, 5)).find("25 loose parts"), std::string::npos) << "a quarter of its surface is of other parts";
  EXPECT_NE(note(parts(19, 0)).find("25 loose parts"), std::string::npos) << "few are convex";
  EXPECT_NE(note(parts(25, 0), 1).find("25 loose parts"), std::string::npos) << "a housing may be open";
}

TEST(PutTogether, NotesShellsThatClosingWouldMakeSolid) {
  const auto notes = [](std::size_t openings, std::size_t hulls, std::size_t uses, double volume = 0.24, double width = 0.1234,
                        double diagonal = 10) {
    MeshResult mesh = boxes(hulls);
    mesh.mesh.diagonal = diagonal;
    mesh.mesh.openings = openings;
    mesh.mesh.widest_opening = width;
    mesh.model.hull_volume = 1;
    mesh.mesh.volume = volume;
    RobotResult result;
    putTogether({use("a"), use("b")}, {shared(mesh), shared(uses > 1 ? mesh : boxes(1))}, result);
    return result.report.notes;
  };
  EXPECT_TRUE(notes(0, 30, 1).empty());
  EXPECT_TRUE(notes(2, 7, 1).empty()) << "they cost little";
  EXPECT_TRUE(notes(2, 30, 1, 0.26).empty()) << "it has its inside already";
  EXPECT_EQ(notes(2, 30, 1, 0.26, 0.21, 1).size(), 1u) << "with openings so wide it hardly has an inside";
  EXPECT_TRUE(notes(2, 30, 1, 0.26, 0.19, 1).empty());
  EXPECT_TRUE(notes(2, 30, 1, 0, 1.01).empty()) << "the option takes no more than 1 m";
  EXPECT_EQ(notes(2, 30, 1, 0, 0.991).size(), 1u);
  EXPECT_EQ(notes(2, 8, 1), (std::vector<std::string>{"'a.stl' has 2 openings and took 8 hulls: if it is the skin of a solid, "
                                                      "--close-openings 13cm makes it that solid, which may take far fewer"}));
  EXPECT_NE(notes(2, 8, 2).at(0).find("8 hulls; 1 other mesh is like it: "), std::string::npos);
}

TEST(PutTogether, NotesThatThePaddingIsPartOfTheProtrusion) {
  RobotResult all, some, none;
  MeshUse padded = use("a");
  padded.options.padding = 0.02;
  putTogether({padded}, {shared(boxes(1))}, all);
  EXPECT_EQ(all.report.notes, (std::vector<std::string>{"the protrusion includes the padding of 20 mm"}));
  putTogether({padded, use("b")}, {shared(boxes(1)), shared(boxes(1))}, some);
  EXPECT_EQ(some.report.notes, (std::vector<std::string>{"the protrusion includes the padding of up to 20 mm"}));
  putTogether({use("b")}, {shared(boxes(1))}, none);
  EXPECT_TRUE(none.report.notes.empty());
}

TEST(PutTogether, NotesOpeningsThatWereClosed) {
  MeshResult mesh = boxes(1);
  mesh.mesh.closed_openings = 3;
  RobotResult result;
  putTogether({use("a"), use("b")}, {shared(mesh), shared(boxes(1))}, result);
  EXPECT_EQ(result.report.notes,
            (std::vector<std::string>{"3 openings of 1 mesh were closed: the hulls cover the lids, too, and protrusion "
                                      "is measured from the closed meshes"}));
}

TEST(PutTogether, NotesWidthsThatCloseNothing) {
  const auto notes = [](const std::vector<MeshResult>& meshes, const std::vector<double>& widths) {
    std::vector<MeshUse> uses;
    MeshResults results;
    for (std::size_t i = 0; i < meshes.size(); ++i) {
      uses.push_back(use(std::string(1, static_cast<char>('a' + i))));
      uses.back().options.close_openings = widths[i];
      results.push_back(shared(meshes[i]));
    }
    RobotResult result;
    putTogether(uses, results, result);
    return result.report.notes;
  };
  MeshResult solid = boxes(1), open = boxes(1), closed = boxes(1), failed = boxes(0);
  open.mesh.openings = 3;
  open.mesh.widest_opening = 0.1234;
  closed.mesh.closed_openings = 1;
  failed.status = Status::kFailed;
  using Notes = std::vector<std::string>;
  const std::string idle = "close-openings 2cm closed nothing: ";
  EXPECT_TRUE(notes({solid, failed}, {0, 0.02}).empty());
  EXPECT_EQ(notes({solid, solid}, {0.02, 0}), Notes{idle + "'a.stl' has none"});
  EXPECT_EQ(notes({solid, solid}, {0.02, 0.02}), Notes{idle + "none of 2 meshes has any"});
  EXPECT_EQ(notes({solid, open}, {0.02, 0.02}),
            Notes{idle + "'b.stl' has 3 openings, up to 124 mm wide, which is the least that closes all of them"});
  EXPECT_EQ(notes({closed, open}, {0.02, 0.02}).size(), 1u) << "what was closed";
  const Notes both = notes({closed, open}, {0.05, 0.02});
  ASSERT_EQ(both.size(), 2u);
  EXPECT_EQ(both[1], idle + "'b.stl' has 3 openings, up to 124 mm wide, which is the least that closes all of them");
}

TEST(PutTogether, TheScaleOfAHugeMeshIsWhereItsInputHasIt) {
  MeshResult huge = boxes(1);
  huge.mesh.diagonal = 300;
  RobotResult mesh, robot;
  robot.report.urdf = "urdf/arm.urdf";
  for (RobotResult* result : {&mesh, &robot}) putTogether({use("a")}, {shared(huge)}, *result);
  EXPECT_NE(mesh.report.notes.at(0).find("scale it by 0.001 (--scale 0.001)"), std::string::npos) << mesh.report.notes[0];
  EXPECT_NE(robot.report.notes.at(0).find("scale=\"0.001 0.001 0.001\""), std::string::npos) << robot.report.notes[0];
}

TEST(PutTogether, NotesSuspiciousSizesOfMeshesThatDidNotFail) {
  MeshResult huge = boxes(1), small = boxes(1), failed = boxes(0);
  huge.mesh.diagonal = 21.4;
  small.mesh.diagonal = 0.009;
  failed.mesh.diagonal = 0;
  failed.status = Status::kFailed;
  RobotResult result;
  putTogether({use("a"), use("b"), use("c")}, {shared(failed), shared(small), shared(huge)}, result);
  ASSERT_EQ(result.report.notes.size(), 2u);
  EXPECT_EQ(result.report.notes[0].substr(0, 20), "'c.stl' is 21.4 m ac") << result.report.notes[0];
  EXPECT_EQ(result.report.notes[1].substr(0, 67), "the tolerance of 10 mm is larger than 'b.stl', which is 9 mm across")
      << result.report.notes[1];
}

TEST(PutTogether, NotesMeshesThatTheirScaleMakesTiny) {
  MeshResult tiny = boxes(1), small = boxes(1);
  tiny.mesh.diagonal = 0.0009;
  tiny.mesh.tolerance = 1e-5;
  small.mesh.diagonal = 0.0011;
  small.mesh.tolerance = 1e-5;
  const auto notesAt = [&](double scale, const std::vector<MeshResult>& meshes) {
    RobotResult result;
    std::vector<MeshUse> uses{use("a"), use("b")};
    for (MeshUse& each : uses) each.source.scale.setConstant(scale);
    putTogether(uses, {shared(meshes[0]), shared(meshes[1])}, result);
    return result.report.notes;
  };
  EXPECT_EQ(notesAt(0.001, {small, tiny}),
            std::vector<std::string>{"'b.stl' is 0.9 mm across with its scale: if its numbers are metres, leave the scale out"});
  EXPECT_EQ(notesAt(0.001, {tiny, tiny}).at(0).substr(0, 64), "'a.stl' is 0.9 mm across with its scale, and 1 other mesh below ");
  EXPECT_TRUE(notesAt(1, {tiny, tiny}).empty());
}

TEST(PutTogether, NotesSizesThatNoWholeNumberHolds) {
  MeshResult huge = boxes(1);
  huge.mesh.diagonal = 3e38;
  RobotResult result;
  putTogether({use("a")}, {shared(huge)}, result);
  EXPECT_EQ(result.report.notes.at(0).substr(0, 26), "'a.stl' is 3e+38 m across:") << result.report.notes[0];
}

TEST(PutTogether, CountsTheOthersOfSuspiciousSize) {
  MeshResult huge = boxes(1);
  huge.mesh.diagonal = 30;
  const auto noteOn = [&](std::size_t count) {
    RobotResult result;
    std::vector<MeshUse> uses;
    for (std::size_t i = 0; i < count; ++i) uses.push_back(use(std::string(1, static_cast<char>('a' + i))));
    putTogether(uses, MeshResults(count, shared(huge)), result);
    return result.report.notes.at(0);
  };
  EXPECT_EQ(noteOn(1).substr(0, 26), "'a.stl' is 30 m across: if");
  EXPECT_EQ(noteOn(2).substr(0, 51), "'a.stl' is 30 m across, and 1 other mesh over 20 m:");
  EXPECT_EQ(noteOn(3).substr(0, 53), "'a.stl' is 30 m across, and 2 other meshes over 20 m:");
}

}  // namespace
}  // namespace collision_hulls
