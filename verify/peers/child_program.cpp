// SPDX-License-Identifier: GPL-3.0-or-later
#include "peers/child_program.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <system_error>

namespace keikan::peers {
namespace {

using Clock = std::chrono::steady_clock;

[[noreturn]] void fail(const char* what) {
    throw std::system_error(errno, std::generic_category(), what);
}

/// Two ends of a pipe, closed at the end of it all.
struct Pipe {
    Pipe() {
        if (pipe2(ends.data(), O_CLOEXEC) != 0) fail("pipe");
    }
    ~Pipe() {
        close_end(0);
        close_end(1);
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    void close_end(std::size_t which) {
        if (ends[which] >= 0) close(ends[which]);
        ends[which] = -1;
    }
    void make_patient(std::size_t which) { fcntl(ends[which], F_SETFL, O_NONBLOCK); }
    int reading() const { return ends[0]; }
    int writing() const { return ends[1]; }
    std::array<int, 2> ends{-1, -1};
};

/// Writing to a program that reads no more is an error to be handled, not our end.
class WithoutPipeSignal {
  public:
    WithoutPipeSignal() {
        struct sigaction ignore {};
        ignore.sa_handler = SIG_IGN;
        sigaction(SIGPIPE, &ignore, &before_);
    }
    ~WithoutPipeSignal() { sigaction(SIGPIPE, &before_, nullptr); }
    WithoutPipeSignal(const WithoutPipeSignal&) = delete;
    WithoutPipeSignal& operator=(const WithoutPipeSignal&) = delete;

  private:
    struct sigaction before_ {};
};

class RunningProgram {
  public:
    explicit RunningProgram(const std::string& command) {
        process_ = fork();
        if (process_ < 0) fail("fork");
        if (process_ == 0) become(command);
        setpgid(process_, process_);  // whoever of the two comes first
        in_.close_end(0);
        out_.close_end(1);
        error_.close_end(1);
        in_.make_patient(1);
        out_.make_patient(0);
        error_.make_patient(0);
    }

    /// Feeds the program and listens to it until it has closed its outputs; false if it was idle for too long
    /// or wrote too much.
    bool converse(std::string_view input, double idle_seconds, std::size_t most_output, ProgramRun& run) {
        std::string complaints;
        Clock::time_point active = Clock::now();
        if (input.empty()) in_.close_end(1);
        while (out_.reading() >= 0 || error_.reading() >= 0) {
            std::array<pollfd, 3> ways{
                {{in_.writing(), POLLOUT, 0}, {out_.reading(), POLLIN, 0}, {error_.reading(), POLLIN, 0}}};
            const double left = idle_seconds - std::chrono::duration<double>(Clock::now() - active).count();
            if (left <= 0) return false;
            if (poll(ways.data(), ways.size(), static_cast<int>(left * 1000) + 1) <= 0) continue;
            active = Clock::now();
            if (ways[0].revents != 0) feed(input);
            if (ways[1].revents != 0) listen(out_, run.output);
            if (ways[2].revents != 0) listen(error_, complaints);
            if (run.output.size() > most_output || complaints.size() > most_output) return false;
            run.last_complaint = last_line(complaints);
        }
        return true;
    }

    /// Waits for its end, which has `idle_seconds` to come; then it is killed. True if it had to be.
    bool finish(bool kill_now, double idle_seconds, ProgramRun& run) {
        const Clock::time_point from = Clock::now();
        bool killed = false;
        int status = 0;
        rusage used{};
        for (;;) {
            if (!killed &&
                (kill_now || std::chrono::duration<double>(Clock::now() - from).count() > idle_seconds)) {
                kill(-process_, SIGKILL);
                killed = true;
            }
            const pid_t ended = wait4(process_, &status, killed ? 0 : WNOHANG, &used);
            if (ended == process_ || (ended < 0 && errno != EINTR)) break;
            if (ended == 0) usleep(500);
        }
        if (!killed) kill(-process_, SIGKILL);  // what it left running
        const auto seconds = [](const timeval& t) {
            return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
        };
        run.processor_seconds = seconds(used.ru_utime) + seconds(used.ru_stime);
        if (WIFSIGNALED(status)) run.signal = WTERMSIG(status);
        if (WIFEXITED(status)) run.exit_code = WEXITSTATUS(status);
        return killed;
    }

  private:
    [[noreturn]] void become(const std::string& command) const {
        setpgid(0, 0);
        signal(SIGPIPE, SIG_DFL);
        const rlimit no_core{0, 0};
        setrlimit(RLIMIT_CORE, &no_core);
        dup2(in_.reading(), STDIN_FILENO);
        dup2(out_.writing(), STDOUT_FILENO);
        dup2(error_.writing(), STDERR_FILENO);
        execl("/bin/sh", "sh", "-c", command.c_str(), static_cast<char*>(nullptr));
        _exit(127);
    }

    void feed(std::string_view& input) {
        const ssize_t written = write(in_.writing(), input.data(), input.size());
        if (written < 0 && (errno == EAGAIN || errno == EINTR)) return;
        if (written > 0) input.remove_prefix(static_cast<std::size_t>(written));
        if (written < 0 || input.empty()) in_.close_end(1);  // it reads no more, or has got it all
    }

    static void listen(Pipe& pipe, std::string& text) {
        std::array<char, 65536> piece;
        const ssize_t read_now = read(pipe.reading(), piece.data(), piece.size());
        if (read_now > 0)
            text.append(piece.data(), static_cast<std::size_t>(read_now));
        else if (read_now == 0 || (errno != EAGAIN && errno != EINTR))
            pipe.close_end(0);
    }

    static std::string last_line(const std::string& text) {
        const std::size_t end = text.find_last_not_of("\r\n");
        if (end == std::string::npos) return {};
        const std::size_t begin = text.find_last_of('\n', end);
        return text.substr(begin + 1, end - begin).substr(0, 240);
    }

    Pipe in_, out_, error_;
    pid_t process_ = -1;
};

}  // namespace

ProgramRun run_program(const std::string& command, std::string_view input, double idle_seconds,
                       std::size_t most_output) {
    constexpr int kShellsSignals = 128;  // added by a shell to the number of the signal that ended its child
    const WithoutPipeSignal no_signal;
    ProgramRun run;
    RunningProgram program(command);
    const bool well = program.converse(input, idle_seconds, most_output, run);
    run.stopped = program.finish(!well, idle_seconds, run);
    if (run.exit_code > kShellsSignals && run.exit_code <= kShellsSignals + 64)
        run.signal = run.exit_code - kShellsSignals;
    return run;
}

}  // namespace keikan::peers
