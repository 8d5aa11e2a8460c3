#include "interrupt.h"

#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>

namespace tp {
namespace {

constexpr std::array kSignals = {SIGINT, SIGTERM, SIGHUP};

std::atomic<bool> saving = false;
std::atomic<int> received = 0;
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<bool>::is_always_lock_free,
              "a signal handler may only use what cannot block");

std::array<struct sigaction, kSignals.size()> old_actions;
struct sigaction old_pipe_action;

void on_signal(int) {
    if (!saving || received.fetch_add(1) > 0) {
        // Off the line of a progress bar or an echoed ^C. Nothing can be done if that fails.
        if (isatty(STDERR_FILENO) != 0 && write(STDERR_FILENO, "\n", 1) < 0) {
        }
        _exit(kInterruptedExitCode);
    }
}

}  // namespace

Interrupt::Interrupt() {
    saving = false;
    received = 0;
    struct sigaction action = {};
    action.sa_handler = on_signal;
    action.sa_flags = SA_RESTART;
    sigemptyset(&action.sa_mask);
    for (size_t i = 0; i < kSignals.size(); ++i) {
        sigaction(kSignals[i], nullptr, &old_actions[i]);
        if (old_actions[i].sa_handler != SIG_IGN) sigaction(kSignals[i], &action, nullptr);
    }
    struct sigaction ignore = {};
    ignore.sa_handler = SIG_IGN;
    sigaction(SIGPIPE, &ignore, &old_pipe_action);
}

Interrupt::~Interrupt() {
    for (size_t i = 0; i < kSignals.size(); ++i)
        sigaction(kSignals[i], &old_actions[i], nullptr);
    sigaction(SIGPIPE, &old_pipe_action, nullptr);
}

void Interrupt::begin_saving() {
    saving = true;
}

bool Interrupt::requested() const {
    return received > 0;
}

}  // namespace tp
