// SPDX-License-Identifier: MIT
// How files are written: whole or not at all, with their mode, and one game at a time.
#include <apart/core/text_file.hpp>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <system_error>
#include <utility>

#ifdef _WIN32
#include <io.h>
#include <process.h>
#else
#include <sys/file.h>
#include <sys/stat.h>

#include <csignal>
#include <fcntl.h>
#include <unistd.h>
#endif

namespace apart {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kFresh = ".new"; // end of the name of a temporary file

#ifdef _WIN32
int processId() {
    return _getpid();
}
#else
int processId() {
    return getpid();
}
#endif

/// Name of a temporary file beside `path`, which no other program and no other call uses.
fs::path temporaryFor(const fs::path& path) {
    static std::atomic<unsigned> calls{0};
    fs::path fresh = path;
    fresh += '.' + std::to_string(processId()) + '-' + std::to_string(++calls);
    fresh += kFresh;
    return fresh;
}

/// Where a chain of symbolic links leads, to a file that need not exist; nullopt: in a circle.
std::optional<fs::path> targetOf(fs::path path) {
    constexpr int kMostLinks = 40;
    for (int i = 0; i < kMostLinks; ++i) {
        std::error_code error;
        if (!fs::is_symlink(fs::symlink_status(path, error))) {
            return path;
        }
        const fs::path next = fs::read_symlink(path, error);
        path = next.is_absolute() ? next : path.parent_path() / next;
    }
    return std::nullopt;
}

#ifdef _WIN32
/// Replaces a file. Returns 0, or the number of the error.
int replaceFile(const fs::path& target, std::string_view text) {
    const fs::path fresh = temporaryFor(target);
    std::FILE* const file = std::fopen(fresh.string().c_str(), "wbx");
    if (file == nullptr) {
        return errno;
    }
    int number = 0;
    if (std::fwrite(text.data(), 1, text.size(), file) != text.size() || std::fflush(file) != 0 ||
        _commit(_fileno(file)) != 0) {
        number = errno;
    }
    if (std::fclose(file) != 0 && number == 0) {
        number = errno;
    }
    std::error_code error;
    if (number == 0) {
        fs::rename(fresh, target, error);
        number = error.value();
    }
    if (number != 0) {
        fs::remove(fresh, error);
    }
    return number;
}
#else
/// Opens a file; closes it at the end of its scope.
class Opened {
public:
    Opened(const fs::path& path, int flags, mode_t mode = 0)
        : number_(open(path.c_str(), flags | O_CLOEXEC, mode)) {}
    ~Opened() {
        if (number_ >= 0) {
            ::close(number_);
        }
    }
    Opened(const Opened&) = delete;
    Opened& operator=(const Opened&) = delete;

    int number() const { return number_; }
    /// Writes a text, which is on the disk then, and closes the file. 0, or the error.
    int finish(std::string_view text) {
        while (!text.empty()) {
            const ssize_t count = ::write(number_, text.data(), text.size());
            if (count < 0 && errno != EINTR) {
                return errno;
            }
            text.remove_prefix(static_cast<std::size_t>(count < 0 ? 0 : count));
        }
        if (fsync(number_) != 0) {
            return errno;
        }
        return ::close(std::exchange(number_, -1)) == 0 ? 0 : errno;
    }

private:
    int number_;
};

fs::path folderOf(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

/// Removes temporary files of `target` that processes left behind which are gone.
void removeLeftovers(const fs::path& target) {
    const std::string head = target.filename().string() + '.';
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folderOf(target), error)) {
        const std::string name = entry.path().filename().string();
        if (!name.starts_with(head) || !name.ends_with(kFresh)) {
            continue;
        }
        const std::string middle =
            name.substr(head.size(), name.size() - head.size() - kFresh.size());
        const std::size_t dash = middle.find('-');
        const std::optional<std::int64_t> process = toNumber(middle.substr(0, dash));
        if (dash != std::string::npos && toNumber(middle.substr(dash + 1)) && process &&
            *process > 0 && kill(static_cast<pid_t>(*process), 0) != 0 && errno == ESRCH) {
            std::error_code ignored;
            fs::remove(entry.path(), ignored);
        }
    }
}

/// Replaces a file, whose mode and owner stay. One with several names is written in place, so that
/// all of them keep one content. Returns 0, or the number of the error.
int replaceFile(const fs::path& target, std::string_view text) {
    struct stat about {};
    const bool exists = ::stat(target.c_str(), &about) == 0;
    constexpr mode_t kAnyMayWrite = S_IWUSR | S_IWGRP | S_IWOTH;
    if (exists && ((about.st_mode & kAnyMayWrite) == 0 || access(target.c_str(), W_OK) != 0)) {
        return EACCES; // also for root, who protects a file by its mode alone
    }
    if (exists && about.st_nlink > 1) {
        Opened file(target, O_WRONLY | O_TRUNC | O_NOFOLLOW);
        return file.number() < 0 ? errno : file.finish(text);
    }
    removeLeftovers(target);
    const fs::path fresh = temporaryFor(target);
    ::unlink(fresh.c_str()); // of an earlier process with this number; in a browser all have one
    Opened file(fresh, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW, exists ? 0600 : 0666);
    if (file.number() < 0) {
        return errno;
    }
    int number = 0;
    if (exists) {
        // Only root may give a file away; for all others the file becomes their own.
        [[maybe_unused]] const int owned = fchown(file.number(), about.st_uid, about.st_gid);
        number = fchmod(file.number(), about.st_mode & 07777) == 0 ? 0 : errno;
    }
    number = number == 0 ? file.finish(text) : number;
    if (number == 0 && std::rename(fresh.c_str(), target.c_str()) != 0) {
        number = errno;
    }
    if (number != 0) {
        std::error_code ignored;
        fs::remove(fresh, ignored);
        return number;
    }
    const Opened folder(folderOf(target), O_RDONLY | O_DIRECTORY);
    if (folder.number() >= 0) {
        fsync(folder.number()); // the new name; some file systems have no such call
    }
    return 0;
}
#endif

} // namespace

#ifdef _WIN32
FolderLock::FolderLock(const fs::path&, int) {}
FolderLock::~FolderLock() = default;
#else
FolderLock::FolderLock(const fs::path& folder, int attempts)
    : folder_(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    while (folder_ >= 0 && flock(folder_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
        if (--attempts <= 0) {
            held_ = false;
            return;
        }
        usleep(5000);
    }
}

FolderLock::~FolderLock() {
    if (folder_ >= 0) {
        close(folder_); // which unlocks it
    }
}
#endif

std::optional<FileProblem> writeTextFile(const fs::path& path, std::string_view text) {
    std::error_code unknown;
    const auto status = fs::status(path, unknown);
    if (fs::exists(status) && !fs::is_directory(status)) {
        if (std::string reason = notAFile(status); !reason.empty()) { // it would be replaced
            return FileProblem{path.string(), 0, std::move(reason)};
        }
    }
    const std::optional<fs::path> target = targetOf(path);
    if (!target) {
        return FileProblem{path.string(), 0, "is a link that leads in a circle"};
    }
    if (const int number = replaceFile(*target, text)) {
        return FileProblem{path.string(), 0,
                           "cannot be written: " + std::generic_category().message(number)};
    }
    return std::nullopt;
}

} // namespace apart
