// SPDX-License-Identifier: MIT
#include <apart/core/text_file.hpp>
#include <support/folder_test.hpp>

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>

namespace apart {
namespace {

namespace fs = std::filesystem;

constexpr const char* kNoFile = "is a pipe, a device or a socket, not a file";

class TextFile : public support::FolderTest {
protected:
    void SetUp() override {
        FolderTest::SetUp();
        fs::create_directories(folder_);
    }

    static std::string reasonOf(const Read<std::string>& read) {
        const auto* problem = std::get_if<FileProblem>(&read);
        return problem != nullptr ? problem->reason : "";
    }
};

// D6: reading a pipe or a device might never end.
TEST_F(TextFile, OnlyRegularFilesAreRead) {
    const fs::path pipe = folder_ / "pipe";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_EQ(reasonOf(readTextFile(pipe, 100)), kNoFile);
    EXPECT_EQ(reasonOf(readTextFile("/dev/zero", 100)), kNoFile);
    EXPECT_EQ(reasonOf(readTextFile(folder_, 100)), "is a folder, not a file");
    EXPECT_EQ(reasonOf(readTextFile(folder_ / "none", 100)), "there is no such file");
}

// D6: the renamed file took the place of the pipe; as root, that of /dev/null.
TEST_F(TextFile, APipeIsNotReplacedByAFile) {
    const fs::path pipe = folder_ / "pipe";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    const auto problem = writeTextFile(pipe, "text");
    ASSERT_TRUE(problem);
    EXPECT_EQ(problem->reason, kNoFile);
    EXPECT_TRUE(fs::is_fifo(pipe));
}

TEST_F(TextFile, ALinkStaysAndItsTargetIsWritten) {
    fs::create_directories(folder_ / "other");
    fs::create_symlink("other/second", folder_ / "first");
    fs::create_symlink(folder_ / "other" / "file", folder_ / "other" / "second");
    for (const char* text : {"one", "two"}) { // without a target, then with one
        ASSERT_FALSE(writeTextFile(folder_ / "first", text));
        EXPECT_TRUE(fs::is_symlink(folder_ / "first"));
        EXPECT_TRUE(fs::is_symlink(folder_ / "other" / "second"));
        EXPECT_FALSE(fs::is_symlink(folder_ / "other" / "file"));
        EXPECT_EQ(std::get<std::string>(readTextFile(folder_ / "other" / "file", 100)), text);
    }
    fs::create_symlink("circle", folder_ / "circle");
    const auto problem = writeTextFile(folder_ / "circle", "text");
    ASSERT_TRUE(problem);
    EXPECT_EQ(problem->reason, "is a link that leads in a circle");
    EXPECT_TRUE(fs::is_symlink(folder_ / "circle"));
}

// I4: as an editor saves a file.
TEST_F(TextFile, SavingKeepsTheModeOfAFile) {
    const fs::path file = folder_ / "file";
    for (const mode_t mode : {0600u, 0640u, 0664u, 0755u}) {
        ASSERT_FALSE(writeTextFile(file, "one"));
        ASSERT_EQ(chmod(file.c_str(), mode), 0);
        ASSERT_FALSE(writeTextFile(file, "two"));
        struct stat about {};
        ASSERT_EQ(stat(file.c_str(), &about), 0);
        EXPECT_EQ(about.st_mode & 07777, mode);
        EXPECT_EQ(std::get<std::string>(readTextFile(file, 100)), "two");
    }
}

TEST_F(TextFile, AProtectedFileStays) {
    const fs::path file = folder_ / "file";
    ASSERT_FALSE(writeTextFile(file, "one"));
    ASSERT_EQ(chmod(file.c_str(), 0444), 0);
    const auto problem = writeTextFile(file, "two");
    ASSERT_TRUE(problem);
    EXPECT_EQ(problem->reason, "cannot be written: Permission denied");
    EXPECT_EQ(std::get<std::string>(readTextFile(file, 100)), "one");
}

TEST_F(TextFile, AllNamesOfAFileKeepOneContent) {
    const fs::path file = folder_ / "file";
    ASSERT_FALSE(writeTextFile(file, "one, and longer"));
    fs::create_hard_link(file, folder_ / "other");
    ASSERT_FALSE(writeTextFile(file, "two"));
    EXPECT_EQ(fs::hard_link_count(file), 2u);
    EXPECT_EQ(std::get<std::string>(readTextFile(folder_ / "other", 100)), "two");
}

/// A process that has ended.
pid_t endedProcess() {
    const pid_t process = fork();
    if (process == 0) {
        _exit(0);
    }
    int status = 0;
    waitpid(process, &status, 0);
    return process;
}

// What a kill while saving leaves is removed by the next save; what others write, or called so
// themselves, is not.
TEST_F(TextFile, SavingRemovesWhatADeadProcessHasLeft) {
    const fs::path file = folder_ / "file";
    const auto left = [&](const std::string& ending) {
        fs::path path = file;
        std::ofstream(path += ending) << "half";
        return path;
    };
    const fs::path dead = left('.' + std::to_string(endedProcess()) + "-7.new");
    const fs::path alive = left('.' + std::to_string(getpid()) + "-999.new");
    const fs::path own = left(".ideas-7.new");
    ASSERT_FALSE(writeTextFile(file, "text"));
    EXPECT_FALSE(fs::exists(dead));
    EXPECT_TRUE(fs::exists(alive));
    EXPECT_TRUE(fs::exists(own));
}

// Numbers of processes come again, and in a browser there is one alone.
TEST_F(TextFile, ALeftoverOfTheOwnNumberIsNoObstacle) {
    const fs::path file = folder_ / "file";
    for (int call = 1; call < 200; ++call) {
        fs::path left = file;
        left += '.' + std::to_string(getpid()) + '-' + std::to_string(call) + ".new";
        std::ofstream(left) << "half of a longer text";
    }
    for (const char* text : {"one", "two"}) {
        ASSERT_FALSE(writeTextFile(file, text));
        EXPECT_EQ(std::get<std::string>(readTextFile(file, 100)), text);
    }
}

// I1: reading, merging and writing exclude each other. A process that is killed lets go.
TEST_F(TextFile, AFolderIsLockedOnceAtATime) {
    {
        const FolderLock first(folder_);
        EXPECT_TRUE(first.held());
        EXPECT_FALSE(FolderLock(folder_, 4).held());
    }
    EXPECT_TRUE(FolderLock(folder_, 4).held());
    int ready[2] = {};
    ASSERT_EQ(pipe(ready), 0);
    const pid_t other = fork();
    if (other == 0) {
        const FolderLock lock(folder_);
        const char answer = lock.held() ? 'y' : 'n';
        if (write(ready[1], &answer, 1) == 1) {
            pause();
        }
        _exit(0);
    }
    char answer = 0;
    ASSERT_EQ(read(ready[0], &answer, 1), 1);
    EXPECT_EQ(answer, 'y');
    EXPECT_FALSE(FolderLock(folder_, 4).held());
    kill(other, SIGKILL);
    int status = 0;
    waitpid(other, &status, 0);
    EXPECT_TRUE(FolderLock(folder_, 4).held());
}

TEST_F(TextFile, ALongerFileThanTheLimitIsRefused) {
    const fs::path file = folder_ / "file";
    ASSERT_FALSE(writeTextFile(file, std::string(100, 'x')));
    EXPECT_EQ(std::get<std::string>(readTextFile(file, 100)), std::string(100, 'x'));
    EXPECT_EQ(reasonOf(readTextFile(file, 99)), "is longer than 99 bytes");
    fs::resize_file(file, std::uintmax_t{1} << 40); // sparse: 1 TiB that take no place
    EXPECT_EQ(reasonOf(readTextFile(file, 16 << 20)), "is longer than 16777216 bytes");
}

// Files of /proc are regular and have content, but report a size of 0.
TEST_F(TextFile, AFileThatReportsNoSizeIsRead) {
    ASSERT_TRUE(fs::exists("/proc/self/status"));
    EXPECT_NE(std::get<std::string>(readTextFile("/proc/self/status", 100000)).find("Pid:"),
              std::string::npos);
    EXPECT_EQ(reasonOf(readTextFile("/proc/self/status", 10)), "is longer than 10 bytes");
}

} // namespace
} // namespace apart
