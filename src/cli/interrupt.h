// Ctrl-C and its relatives (SIGINT, SIGTERM, SIGHUP) during a command.
#pragma once

namespace tp {

constexpr int kInterruptedExitCode = 130;

/// While one lives, it decides what the signals do. At first they end the process at once, with
/// kInterruptedExitCode. After begin_saving() the first one only sets requested(), and the second
/// ends the process. Signals that were ignored before, as under nohup, stay ignored; so does
/// SIGPIPE: a render outlives the terminal that watches it.
class Interrupt {
public:
    Interrupt();
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

    void begin_saving();
    bool requested() const;
};

}  // namespace tp
