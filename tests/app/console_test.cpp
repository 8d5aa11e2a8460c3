// The console: what is logged is what is shown, filtered, copied and cleared.
#include "window_test.h"

#include <teapath/core/log.h>

#include <doctest/doctest.h>

#include <string>

using namespace tp;
using namespace tp::test;

namespace {

// What "Copy" puts onto the clipboard.
std::string copied(ImGuiTestContext* ctx) {
    ctx->ItemClick("//Console/Copy");
    return ImGui::GetClipboardText();
}

bool has(const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("console: the filter has words, words to leave out, and a comma for or") {
    WindowTest t;
    log_line(LogLevel::Info, "apple pie");
    log_line(LogLevel::Warning, "apple %s %n tart %");
    log_line(LogLevel::Error, "cherry pie");
    t.run([&](ImGuiTestContext* ctx) {
        ctx->WindowFocus("//Console");
        ctx->Yield(2);
        const std::string all = copied(ctx);
        CHECK(has(all, "apple pie"));
        CHECK(has(all, "apple %s %n tart %"));  // never taken for a format
        CHECK(has(all, "cherry pie"));
        const auto shown = [&](const char* filter) {
            ctx->ItemInputValue("//Console/##filter", filter);
            ctx->Yield();
            return copied(ctx);
        };
        const std::string apples = shown("apple");
        CHECK(has(apples, "apple pie"));
        CHECK_FALSE(has(apples, "cherry"));
        const std::string no_pies = shown("-pie");
        CHECK(has(no_pies, "tart"));
        CHECK_FALSE(has(no_pies, "pie"));
        const std::string either = shown("tart,cherry");
        CHECK(has(either, "tart"));
        CHECK(has(either, "cherry"));
        CHECK_FALSE(has(either, "apple pie"));
        CHECK_FALSE(has(shown("apple,-tart"), "tart"));
        shown("");
        ctx->ItemClick("//Console/Clear");
        ctx->Yield();
        CHECK_FALSE(has(copied(ctx), "pie"));
        log_line(LogLevel::Info, "after clearing");
        ctx->Yield(2);
        CHECK(has(copied(ctx), "after clearing"));
    });
}

TEST_CASE("console: its lines are bounded") {
    WindowTest t;
    for (int i = 0; i < 6000; ++i)
        log_line(LogLevel::Info, "line " + std::to_string(i));
    t.frames(5);
    CHECK(t.app->ui.console.lines.size() <= 5000);
    CHECK(t.app->ui.console.lines.back().text == "line 5999");
}
