// Files of the person at the machine: where programs keep theirs, and writing one so that it is never half there.
#pragma once

#include <filesystem>
#include <string>

namespace tumble {

// The folder in which a program keeps what it stores for this person, or an empty path where the system names none:
// $XDG_DATA_HOME or ~/.local/share, %APPDATA%, ~/Library/Application Support.
std::filesystem::path data_folder();

// Writes beside the file first, lets that reach the disk, then puts it in the file's place, making folders on the way:
// whoever reads sees the old text or the new, also after a power cut. Throws Error with the reason alone.
void write_whole_file(const std::filesystem::path& file, const std::string& text);

}  // namespace tumble
