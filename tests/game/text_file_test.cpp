// SPDX-License-Identifier: MIT
#include <apart/core/text_file.hpp>
#include <support/folder_test.hpp>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <string>

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
