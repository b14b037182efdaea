// SPDX-License-Identifier: GPL-3.0-or-later
#include "report.hpp"

#include <system_error>

#include "error_picture.hpp"
#include "keikan/image/png_file.hpp"
#include "keikan/support/atomic_file.hpp"
#include "keikan/support/input_error.hpp"

namespace keikan::crosscheck {

void make_report_folder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (!error && !std::filesystem::is_directory(folder))
        error = std::make_error_code(std::errc::not_a_directory);
    if (error) throw InputError(folder.string(), "", "cannot be made: " + error.message());
}

void write_report(const std::filesystem::path& folder, const Image<Rgb>& picture, const SceneCheck& check,
                  const std::string& summary) {
    const ErrorScale scale = scale_for(check.errors());
    write_png(folder / "picture.png", picture);
    write_png(folder / "error.png", error_picture(check.errors(), check.wrong(), scale));
    write_whole_file(folder / "error_legend.txt", error_legend(scale));
    write_png(folder / "flags.png", flag_picture(check.flags()));
    write_whole_file(folder / "summary.json", summary + "\n");
}

}  // namespace keikan::crosscheck
