#include "whittle/engine/decimate.hh"

#include "decimate/run.hh"
#include "whittle/core/frame.hh"
#include "whittle/engine/attributes.hh"
#include "whittle/engine/detail/without_backs.hh"
#include "whittle/engine/two_sided_sheets.hh"

namespace whittle {

Decimation decimate(const IndexedMesh& mesh, const DecimateTarget& target, const DecimateOptions& options) {
  if (const TwoSidedSheets sheets(mesh, options.threads); sheets.any()) {
    return detail::run_without_backs(sheets, target, options,
                                     [&](const DecimateTarget& own, const DecimateOptions& own_options) {
                                       return decimate(sheets.without_backs(), own, own_options);
                                     });
  }
  Decimation decimation = run(mesh, target, options, nullptr, {});
  break_normals(Frame::of_points(mesh.positions), options.normals, options.crease_angle_deg, decimation.mesh);
  return decimation;
}

Decimation decimate(const IndexedMesh& mesh, const DecimateTarget& target, const DecimateOptions& options,
                    DecimationHost& host) {
  return run(mesh, target, options, &host, {});
}

bool goes_in_blocks(const IndexedMesh& mesh, const DecimateTarget& target, const DecimateOptions& options) {
  return why_not_in_blocks(mesh, target, options, nullptr, {}, options.listener || options.keep_steps).empty();
}

}  // namespace whittle
