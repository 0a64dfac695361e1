#include "commands/recording/curve.hh"

#include "charts/svg_chart.hh"
#include "terminal/progress_bar.hh"
#include "terminal/table.hh"
#include "whittle/metrics/distance.hh"
#include "whittle/pipeline/values.hh"

namespace whittle::app {
namespace {

CurvePoint measure(const progressive::Replay& replay, metrics::DistanceReference& input,
                   const metrics::DistanceOptions& options) {
  CurvePoint point{replay.n_faces(), replay.n_vertices(), replay.cost(), 0, 0, 0};
  if (replay.level() == 0) return point;
  const metrics::SurfaceDistance distance = input.to(replay.decimation().mesh, options);
  point.mean = distance.mean;
  point.rms = distance.rms;
  point.max = distance.max;
  return point;
}

}  // namespace

std::vector<CurvePoint> measure_curve(progressive::Replay& replay, std::size_t samples, unsigned threads,
                                      const Talk& talk) {
  ProgressBar bar(talk, "measuring the curve");
  const std::vector<std::size_t> levels = progressive::levels_of_curve(replay);
  metrics::DistanceReference input(replay.input());
  std::vector<CurvePoint> curve;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    replay.go_to(levels[i]);
    if (replay.n_faces() == 0) break;
    const auto n = static_cast<double>(levels.size());
    metrics::DistanceOptions options;
    options.samples = samples;
    options.threads = threads;
    options.progress = part_of(bar, static_cast<double>(i) / n, static_cast<double>(i + 1) / n);
    curve.push_back(measure(replay, input, options));
  }
  return curve;
}

std::string curve_csv(const std::vector<CurvePoint>& curve) {
  std::string text = "faces,vertices,max_cost,mean,rms,max\n";
  for (const CurvePoint& point : curve) {
    text += std::to_string(point.n_faces) + ',' + std::to_string(point.n_vertices) + ',' + shortest(point.max_cost) +
            ',' + shortest(point.mean) + ',' + shortest(point.rms) + ',' + shortest(point.max) + '\n';
  }
  return text;
}

std::string curve_svg(const std::vector<CurvePoint>& curve, const std::string& name) {
  Chart chart{"Error of " + name, "faces", "distance, model units", {}};
  const auto add = [&](const std::string& what, double CurvePoint::*distance) {
    ChartSeries series{what, {}};
    for (const CurvePoint& point : curve) {
      series.points.push_back({static_cast<double>(point.n_faces), point.*distance,
                               faces_text(point.n_faces) + ": " + significant(point.*distance), what});
    }
    chart.series.push_back(std::move(series));
  };
  add("largest", &CurvePoint::max);
  add("root mean square", &CurvePoint::rms);
  add("mean", &CurvePoint::mean);
  return to_svg(chart);
}

Json curve_json(const std::vector<CurvePoint>& curve) {
  Json json = Json::array();
  for (const CurvePoint& point : curve) {
    json.push_back({{"faces", point.n_faces},
                    {"vertices", point.n_vertices},
                    {"max_cost", point.max_cost},
                    {"mean", point.mean},
                    {"rms", point.rms},
                    {"max", point.max}});
  }
  return json;
}

}  // namespace whittle::app
