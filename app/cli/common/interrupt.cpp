// interrupt.cpp: a handler that does nothing but remember.
#include "app/cli/common/interrupt.h"

#include <csignal>

namespace neph {
namespace {

volatile std::sig_atomic_t noted = 0;

void note(int signal) {
    noted = signal;
}

}  // namespace

void noteInterrupts() {
    struct sigaction action {};
    action.sa_handler = note;
    // One whose parent ends gets SIGTERM once for each thread of the parent.
    action.sa_flags = SA_RESTART;
    for (const int signal : {SIGTERM, SIGHUP}) sigaction(signal, &action, nullptr);
    action.sa_flags |= static_cast<int>(SA_RESETHAND);
    sigaction(SIGINT, &action, nullptr);
    std::signal(SIGPIPE, SIG_IGN);
}

int interruptSignal() {
    return noted;
}

Progress untilInterrupted() {
    return [](double) { return interruptSignal() == 0; };
}

}  // namespace neph
