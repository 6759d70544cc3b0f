// SPDX-License-Identifier: MIT
#include <apart/sfml/interruption.hpp>

#include <csignal>
#include <initializer_list>

namespace apart {

namespace {

volatile std::sig_atomic_t arrived = 0;

extern "C" void noteSignal(int) {
    arrived = 1;
}

} // namespace

#ifdef _WIN32
void watchForInterruption() {
    for (const int number : {SIGINT, SIGTERM}) {
        std::signal(number, noteSignal);
    }
}
#else
void watchForInterruption() {
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction former {};
        sigaction(number, nullptr, &former);
        if (former.sa_handler == SIG_IGN) {
            continue;
        }
        struct sigaction noting {};
        noting.sa_handler = noteSignal;
        noting.sa_flags = SA_RESTART;
        sigaction(number, &noting, nullptr);
    }
}
#endif

bool isInterrupted() {
    return arrived != 0;
}

} // namespace apart
