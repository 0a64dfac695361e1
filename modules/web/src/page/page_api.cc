#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "page/session.hh"
#include "whittle/pipeline/option.hh"

// What the worker of the page calls (page/src/engine.js). There is one session at a time. Names are written into
// `text_of`; answers are JSON. Errors are exceptions (support/exceptions.cc), which end the instance.

#define WHITTLE_EXPORT(name) extern "C" __attribute__((export_name(#name)))

namespace whittle::web::exported {
namespace {

std::unique_ptr<Session> session;
std::string text;    ///< written by JavaScript
std::string answer;  ///< read by JavaScript
report::PageData data;

/// Tells JavaScript how far the work is. \param stage a text of `length` bytes
__attribute__((import_module("whittle"), import_name("stage"))) void tell_stage(double fraction, const char* stage,
                                                                                std::size_t length, double n_faces);

bool observe(const RunProgress& progress) {
  tell_stage(progress.fraction, progress.stage.data(), progress.stage.size(), static_cast<double>(progress.n_faces));
  return true;
}

const char* answered(const Json& json) {
  answer = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  return answer.c_str();
}

/// \param number NaN if it isn't given
template <class Number>
std::optional<Number> given(double number) {
  if (std::isnan(number)) return std::nullopt;
  return static_cast<Number>(number);
}

}  // namespace

WHITTLE_EXPORT(text_of) char* text_of(std::size_t length) {
  text.resize(length);
  return text.data();
}

/// The text is the name of the file.
WHITTLE_EXPORT(open_session) const char* open_session() {
  session.reset();
  session = std::make_unique<Session>(text, observe);
  return answered(session->facts());
}

WHITTLE_EXPORT(record_levels) void record_levels() { session->record(); }
WHITTLE_EXPORT(measure_next_level) const char* measure_next_level() { return answered(session->measure_next_level()); }

/// The text is the effort. \param n_faces, max_error NaN: none
WHITTLE_EXPORT(simplify_session) const char* simplify_session(double n_faces, double max_error) {
  const auto effort =
      std::find_if(efforts.begin(), efforts.end(), [](const auto& choice) { return choice.word == text; });
  if (effort == efforts.end()) throw std::invalid_argument("'" + text + "' is no effort");
  return answered(session->simplify(given<std::uint64_t>(n_faces), given<double>(max_error), effort->value));
}

WHITTLE_EXPORT(measure_result) const char* measure_result() { return answered(session->measure_result()); }

/// The text is the format's name. The answer has the warnings.
WHITTLE_EXPORT(write_result) const char* write_result() { return answered(session->write(text)); }

/// The answer is the page's JSON.
WHITTLE_EXPORT(page_json) const char* page_json() {
  data = session->page_data();
  answer = std::move(data.json);
  return answer.c_str();
}
WHITTLE_EXPORT(page_bytes) const unsigned char* page_bytes() { return data.bytes.data(); }
WHITTLE_EXPORT(n_page_bytes) std::size_t n_page_bytes() { return data.bytes.size(); }

}  // namespace whittle::web::exported
