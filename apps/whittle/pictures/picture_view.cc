#include "pictures/picture_view.hh"

namespace whittle::app {

PictureView picture_view(const PageSettings& settings) {
  PictureView view;
  const auto set = [&settings](const char* name, auto& value, const auto& parse) {
    const auto found = settings.find(name);
    if (found != settings.end()) value = parse(found->second);
  };
  const auto word = [](const std::string& text) { return text; };
  const auto number = [](const std::string& text) { return std::stod(text); };
  const auto whole = [](const std::string& text) { return static_cast<int>(std::stod(text)); };
  const auto is = [](const std::string& chosen) {
    return [chosen](const std::string& text) { return text == chosen; };
  };
  set("layout", view.layout, word);
  set("split", view.split, number);
  set("result", view.result, whole);
  set("colour", view.colour, word);
  set("top", view.top, word);
  set("ghost", view.ghost, word);
  set("shading", view.shading, word);
  set("up", view.up, word);
  set("faces", view.faces, is("on"));
  set("edges", view.edges, is("on"));
  set("borders", view.borders, is("on"));
  set("nonmanifold", view.nonmanifold, is("on"));
  set("level", view.level, number);
  set("spacing", view.is_by_faces, is("faces"));
  set("movement", view.is_continuous, is("continuous"));
  set("turn", view.turn_deg, number);
  set("tilt", view.tilt_deg, number);
  set("zoom", view.zoom, number);
  view.is_plain = settings.contains("plain");
  view.has_level = settings.contains("level");
  return view;
}

}  // namespace whittle::app
