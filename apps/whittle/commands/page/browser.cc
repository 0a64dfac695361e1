#include "commands/page/browser.hh"

#include <array>
#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include "commands/page/child_process.hh"
#include "whittle/core/bytes/base64.hh"

// Chrome DevTools Protocol: https://chromedevtools.github.io/devtools-protocol. Messages are JSON, each ended by a zero
// byte, through the two pipes of --remote-debugging-pipe.

namespace whittle::app {
namespace {

using Message = nlohmann::json;

constexpr std::array<const char*, 5> browsers{"chromium", "chromium-browser", "google-chrome", "google-chrome-stable",
                                              "chrome"};

/// All that is drawn is computed by the processor alone.
std::vector<std::string> browser_options(const WorkFolder& folder) {
  std::vector<std::string> options{"--headless",
                                   "--remote-debugging-pipe",
                                   "--hide-scrollbars",
                                   "--disable-dev-shm-usage",  // containers have little of it
                                   "--use-angle=swiftshader",
                                   "--enable-unsafe-swiftshader",
                                   "--no-first-run",
                                   "--user-data-dir=" + folder / "profile"};
  if (is_root()) options.emplace_back("--no-sandbox");
  return options;
}

std::unique_ptr<TalkingProcess> start_browser(const std::vector<std::string>& options) {
  for (const char* const browser : browsers) {
    std::vector<std::string> words{browser};
    words.insert(words.end(), options.begin(), options.end());
    if (std::unique_ptr<TalkingProcess> process = TalkingProcess::start(std::move(words))) return process;
  }
  throw std::runtime_error("pictures need Chromium, which is not installed (on Debian: apt install chromium)");
}

}  // namespace

/// One page in one browser.
class PageView::Session {
 public:
  Session(const std::string& page, const std::string& settings, const PictureSize& size)
      : browser_(start_browser(browser_options(folder_))) {
    std::ofstream(folder_ / "page.html", std::ios::binary) << page;
    const Message target = call("Target.createTarget", {{"url", "about:blank"}});
    session_ = call("Target.attachToTarget", {{"targetId", target.at("targetId")}, {"flatten", true}}).at("sessionId");
    call("Emulation.setDeviceMetricsOverride",
         {{"width", size.width}, {"height", size.height}, {"deviceScaleFactor", 1}, {"mobile", false}});
    call("Page.navigate", {{"url", "file://" + folder_ / "page.html" + "#picture&" + settings}});
    wait_for_page();
  }
  ~Session() {
    try {
      call("Browser.close", Message::object());
    } catch (const std::exception&) {  // it is gone already
    }
  }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  std::string evaluate(const std::string& script) {
    const Message result =
        call("Runtime.evaluate", {{"expression", script}, {"awaitPromise", true}, {"returnByValue", true}});
    if (result.contains("exceptionDetails")) throw std::runtime_error("the page can't be drawn: " + result.dump());
    const Message& value = result.at("result");
    return value.contains("value") && value["value"].is_string() ? value["value"].get<std::string>() : std::string();
  }
  /// \throw std::runtime_error if Chromium refuses
  Message call(const std::string& method, const Message& parameters) {
    Message message{{"id", ++n_calls_}, {"method", method}, {"params", parameters}};
    if (!session_.empty() && !method.starts_with("Browser.")) message["sessionId"] = session_;
    browser_->write(message.dump() + '\0');
    while (true) {
      Message answer = Message::parse(browser_->read_until('\0'));
      if (answer.value("id", 0) != n_calls_) continue;  // an event
      if (answer.contains("error"))
        throw std::runtime_error("Chromium refuses " + method + ": " + answer["error"].dump());
      return std::move(answer.at("result"));
    }
  }

 private:
  void wait_for_page() {
    constexpr std::chrono::milliseconds wait(20);
    while (true) {
      const std::string state = evaluate("window.whittle ? 'ready' : document.documentElement?.dataset.ready || ''");
      if (state == "failed") throw std::runtime_error("Chromium can't show the page");
      if (state == "ready") return;
      std::this_thread::sleep_for(wait);
    }
  }

  WorkFolder folder_;  // there until the browser has ended
  std::unique_ptr<TalkingProcess> browser_;
  std::string session_;
  int n_calls_ = 0;
};

PageView::PageView(const std::string& page, const std::string& settings, const PictureSize& size)
    : session_(std::make_unique<Session>(page, settings, size)) {}

PageView::~PageView() = default;

void PageView::go_to(double place) { session_->evaluate("window.whittle.showPlace(" + std::to_string(place) + ")"); }

std::string PageView::picture(const std::string& format) {
  session_->evaluate("window.whittle.drawn()");
  const nlohmann::json shot = session_->call("Page.captureScreenshot", {{"format", format}});
  return decode_base64(shot.at("data").get_ref<const std::string&>()).value();
}

bool open_on_desktop(const std::string& path) { return run_quietly({"xdg-open", path}).value_or(1) == 0; }

}  // namespace whittle::app
