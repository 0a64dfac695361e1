#include "packed_recording.hh"
#include "packed_surface.hh"
#include "page_bytes.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/report/page.hh"

namespace whittle::report {
namespace {

Box bounds_of_all(const Page& page) {
  Box all = bounds_of(page.original.mesh);
  for (const PageSurface& result : page.results) all.extend(bounds_of(result.mesh));
  if (page.recording) {
    for (const Contraction& c : page.recording->replay.steps().contractions) all.extend(c.position);
    for (const PassEnd& end : page.recording->replay.steps().pass_ends) {
      for (const auto& [vertex, position] : end.moved) all.extend(position);
    }
  }
  return all;
}

Json pack(const Page& page, PageBytes& bytes) {
  const Grid grid = Grid::around(bounds_of_all(page));
  Json json;
  json["title"] = page.title;
  json["advice"] = page.advice;
  json["origin"] = {grid.origin.x(), grid.origin.y(), grid.origin.z()};
  json["step"] = grid.step;
  PageImages images;
  json["original"] = pack(page.original, grid, bytes, images);
  json["results"] = Json::array();
  for (const PageSurface& result : page.results) {
    json["results"].push_back(pack(result, grid, bytes, images));
  }
  json["recording"] = page.recording ? pack(*page.recording, grid, bytes) : Json(nullptr);
  json["images"] = images.pack(bytes);
  if (const std::optional<PageLive>& live = page.live) {
    json["live"] = {{"stage", live->stage},   {"fraction", live->fraction}, {"faces", live->n_faces},
                    {"target", live->target}, {"seconds", live->seconds},   {"problem", live->problem}};
  }
  return json;
}

}  // namespace

PageData page_data(const Page& page) {
  PageBytes bytes;
  const Json json = pack(page, bytes);
  return {json.dump(-1, ' ', false, Json::error_handler_t::replace), bytes.take()};
}

}  // namespace whittle::report
