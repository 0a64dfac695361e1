#include "commands/simplify/simplify_report.hh"

#include "system/system.hh"

namespace whittle::app {

Json simplify_json(const SimplifyCommand& options, const SimplifyRecord& record) {
  Json json = new_report();
  json.update(run_json(record.plan, record.outcome, simplify_options_json(options)));
  json["curve"] = options.curve ? curve_json(record.curve) : Json(nullptr);
  json["seconds"] = {{"read", record.read_seconds},
                     {"decimate", record.decimate_seconds()},
                     {"polish", record.outcome.seconds.polish},
                     {"certify", record.outcome.seconds.certify},
                     {"curve", record.curve_seconds},
                     {"write", record.write_seconds},
                     {"total", record.total_seconds}};
  json["peak_rss_bytes"] = peak_memory_bytes();
  json["warnings"] = record.warnings;
  return json;
}

}  // namespace whittle::app
