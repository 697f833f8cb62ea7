// decompose and verify prefer different elements of a link that has both: the one decomposes what planners see, the other asks how well
// that stands for the robot's shape. A result of decompose or fit_scene is therefore compared with what it was made from, if its report
// says what that is.
#include <filesystem>

#include "collision_hulls/verify/verify.h"
#include "report/earlier_report.h"
#include "storage/sha256.h"

namespace collision_hulls {

namespace fs = std::filesystem;

std::optional<MadeFrom> madeFrom(const Description& original, const Description& result) {
  if (original.robot.text.empty() || result.robot.path.empty()) return std::nullopt;
  const fs::path folder = fs::absolute(result.robot.path).parent_path().parent_path();
  const std::optional<EarlierSource> earlier = earlierSource(folder);
  if (!earlier || earlier->input_sha256 != sha256(original.robot.text)) return std::nullopt;
  return MadeFrom{(folder / kReportFile).string(), earlier->source, earlier->close_openings, earlier->fitted, earlier->of_link};
}

}  // namespace collision_hulls
