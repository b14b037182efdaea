// SPDX-License-Identifier: Apache-2.0
#include "run_keikan.hpp"

#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "../support/scratch_folder.hpp"

bool Run::complains_in_one_line() const {
    return err.starts_with("keikan: ") && err.ends_with('\n') &&
           std::count(err.begin(), err.end(), '\n') == 1;
}

Run run_keikan(const std::string& arguments, const std::string& input) {
    const ScratchFolder folder("run");
    std::ofstream(folder / "in", std::ios::binary) << input;
    const std::string in = folder / "in", out = folder / "out", err = folder / "err";
    // What `arguments` redirects comes later, and so counts.
    const std::string command = "<" + in + " >" + out + " 2>" + err + " " KEIKAN_PROGRAM " " + arguments;
    const int status = std::system(command.c_str());
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return {code, contents(out), contents(err)};
}

std::string hill() {
    return KEIKAN_SOURCE_DIR "/data/scenes/hill.json";
}
