#include "core/files/atomic_file.hpp"
#include "tests/support/temporary_folder.hpp"

#include <csignal>
#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

namespace rayscope::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;

std::string message_of(const std::function<void()>& action) {
    try {
        action();
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "";
}

TEST(AtomicFile, appears_on_commit_with_its_whole_content) {
    const TemporaryFolder folder;
    const fs::path path = folder.path() / "a.txt";
    {
        AtomicFile file(path);
        std::ofstream(file.temporary()) << "new";
        EXPECT_FALSE(fs::exists(path));
        file.commit();
    }
    EXPECT_EQ(content_of(path), "new");
    EXPECT_EQ(folder.names(), std::vector<std::string>{"a.txt"});
}

TEST(AtomicFile, a_program_that_is_killed_leaves_nothing) {
    const TemporaryFolder folder;
    const pid_t child = fork();
    if (child == 0) {
        const AtomicFile file(folder.path() / "a.txt");
        std::ofstream(file.temporary()) << "half";
        std::raise(SIGKILL);
    }
    waitpid(child, nullptr, 0);
    const int probe = ::open(folder.path().c_str(), O_TMPFILE | O_WRONLY, 0600);
    if (probe < 0) GTEST_SKIP() << "this file system has no files without a name";
    ::close(probe);
    EXPECT_THAT(folder.names(), IsEmpty());
}

TEST(AtomicFile, without_commit_the_old_file_stays_and_nothing_else) {
    const TemporaryFolder folder;
    const fs::path path = folder.path() / "a.txt";
    std::ofstream(path) << "old";
    {
        const AtomicFile file(path);
    }
    EXPECT_EQ(content_of(path), "old");
    EXPECT_EQ(folder.names(), std::vector<std::string>{"a.txt"});
}

TEST(AtomicFile, has_the_permissions_of_an_ordinary_file) {
    const TemporaryFolder folder;
    std::ofstream(folder.path() / "ordinary") << "x";
    write_text_file(folder.path() / "atomic", "x");
    EXPECT_EQ(fs::status(folder.path() / "atomic").permissions(),
              fs::status(folder.path() / "ordinary").permissions());
}

TEST(AtomicFile, follows_a_link_and_keeps_it) {
    const TemporaryFolder folder;
    fs::create_directory(folder.path() / "far");
    std::ofstream(folder.path() / "far/target") << "old";
    fs::create_symlink("far/target", folder.path() / "link");
    write_text_file(folder.path() / "link", "new");
    EXPECT_TRUE(fs::is_symlink(folder.path() / "link"));
    EXPECT_EQ(content_of(folder.path() / "far/target"), "new");
}

TEST(AtomicFile, says_why_a_file_cannot_be_written) {
    const TemporaryFolder folder;
    const auto message = [](const fs::path& path) { return message_of([&] { check_writable(path); }); };
    EXPECT_THAT(message(folder.path() / "no/a.png"), HasSubstr("a.png: its folder does not exist"));
    EXPECT_THAT(message(folder.path()), HasSubstr("it is a folder"));
    EXPECT_THAT(message("/dev/null"), HasSubstr("not a regular file"));
    EXPECT_THAT(message(""), HasSubstr("a file name was expected"));
    EXPECT_THAT(message(folder.path() / std::string(300, 'a')), HasSubstr("longer than 255 bytes"));
    std::ofstream(folder.path() / "file") << "x";
    EXPECT_THAT(message(folder.path() / "file/a.png"), HasSubstr("can't write"));
    EXPECT_THAT(message(folder.path() / "fine.png"), IsEmpty());
    EXPECT_EQ(folder.names(), std::vector<std::string>{"file"});
}

} // namespace
} // namespace rayscope::test
