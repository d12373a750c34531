#include "snug/formats/zip_read.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "snug/words/words.h"

#include "cli/inflate.h"
#include "tests/support/random.h"
#include "tests/support/read_checks.h"
#include "tests/support/zip_builder.h"

namespace snug::test {
namespace {

std::string text_of(const FileBytes& bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// The names and texts of an archive, or the sentence that says why they cannot be read.
std::vector<std::string> contents(const std::string& file) {
    auto zip = ZipReader::open(bytes_of(file), cli::inflate);
    if (!zip) return {text(zip.error().message)};
    std::vector<std::string> found;
    for (const ZipMember& member : zip->members()) {
        const auto bytes = zip->unpack(member);
        found.push_back(member.name);
        found.push_back(bytes ? text_of(*bytes) : text(bytes.error().message));
    }
    return found;
}

const std::vector<ZipPart> kTwo = {{"a.txt", "first"}, {"folder/b.txt", "the second"}};
const std::vector<std::string> kTwoTexts = {"a.txt", "first", "folder/b.txt", "the second"};

TEST(ZipRead, MembersAreFoundHoweverTheArchiveIsWritten) {
    for (const bool deflated : {false, true}) {
        for (const bool descriptor : {false, true}) {
            for (const bool zip64 : {false, true}) {
                for (const bool end64 : {false, true}) {
                    for (const char* junk : {"", "#!/bin/sh\nexec unzip PK\n"}) {
                        for (const char* comment :
                             {"", "a comment", "PK\x05\x06 is how an end begins, and 22 bytes more"}) {
                            std::vector<ZipPart> parts = kTwo;
                            for (ZipPart& part : parts) {
                                part.deflated = deflated;
                                part.descriptor = descriptor;
                                part.zip64 = zip64;
                            }
                            EXPECT_EQ(contents(zip_of(parts, {junk, comment, end64, false})), kTwoTexts)
                                << deflated << descriptor << zip64 << end64 << junk << comment;
                        }
                    }
                }
            }
        }
    }
    EXPECT_EQ(contents(zip_of(kTwo) + "bytes behind it"), kTwoTexts);
    EXPECT_TRUE(contents(zip_of({})).empty());
    EXPECT_EQ(contents(zip_of({{"empty", ""}, {"empty too", "", true}})),
              (std::vector<std::string>{"empty", "", "empty too", ""}));
}

TEST(ZipRead, NamesAreUtf8OrCodePage437WithSlashes) {
    EXPECT_EQ(contents(zip_of({{"3D\\b\x81ste.model", "x"}}))[0], "3D/b\u00fcste.model");
    EXPECT_EQ(contents(zip_of({{"b\u00fcste.stl", "x"}}))[0], "b\u00fcste.stl");
    ZipPart flagged{"b\u00fcste.stl", "x"};
    flagged.utf8 = true;
    EXPECT_EQ(contents(zip_of({flagged}))[0], "b\u00fcste.stl");
}

TEST(ZipRead, WhatCannotBeUnpackedIsNamedAndTheRestIsNot) {
    ZipPart secret{"secret.txt", "x"}, lzma{"other.txt", "x"}, hurt{"hurt.txt", "x"};
    secret.flags = 1;
    lzma.method = 14;
    hurt.wrong_checksum = 1;
    const auto found = contents(zip_of({{"a", "good"}, secret, lzma, hurt}));
    ASSERT_EQ(found.size(), 8u);
    EXPECT_EQ(found[1], "good");
    expect_holds(found[3], "\"secret.txt\" in the zip archive is encrypted");
    expect_holds(found[5], "packed by method 14");
    expect_holds(found[7], "\"hurt.txt\" in the zip archive is damaged");
}

TEST(ZipRead, AnArchiveThatIsNotWholeIsASentence) {
    const std::string whole = zip_of({{"a.txt", "first", true}, {"b.txt", "second"}});
    expect_holds(contents(whole.substr(0, whole.size() - 30))[0], "cut off");
    expect_holds(contents("PK\x03\x04")[0], "cut off");
    for (std::size_t size = 0; size < whole.size(); ++size)
        EXPECT_EQ(contents(whole.substr(0, size)).size(), 1u) << size;
}

TEST(ZipRead, MembersThatShareBytesAreRefused) {
    expect_holds(contents(zip_of(kTwo, {"", "", false, true}))[0], "share bytes");
}

TEST(ZipRead, MoreThanTheLimitIsRefusedBeforeItIsUnpacked) {
    ZipPart bomb{"bomb.xml", "little", true};
    bomb.claimed_size = 4'000'000'000;
    expect_holds(contents(zip_of({bomb}))[1], "100 times its bytes, or 64 MiB");
    // A size that is a lie is found while unpacking.
    bomb.claimed_size = 3;
    expect_holds(contents(zip_of({bomb}))[1], "damaged");
    // The limit is that of all members together.
    std::vector<ZipPart> many(3);
    for (std::size_t i = 0; i < many.size(); ++i) {
        many[i] = {std::to_string(i), std::string(1000, ' ')};
        many[i].method = 8;  // so that what is there is damaged, but would count
        many[i].claimed_size = 30'000'000;
    }
    const auto found = contents(zip_of(many));
    expect_holds(found[1], "damaged");
    expect_holds(found[3], "damaged");
    expect_holds(found[5], "64 MiB");
}

TEST(ZipRead, DamagedArchivesAreSentencesOrHaveTrueMembers) {
    for (std::uint64_t seed = 1; seed <= 5000; ++seed) {
        Random random(seed);
        std::vector<ZipPart> parts = kTwo;
        for (ZipPart& part : parts) {
            part.deflated = random.chance(0.5);
            part.zip64 = random.chance(0.3);
        }
        std::string file = zip_of(parts, {random.chance(0.3) ? "junk" : "", "c", random.chance(0.3), false});
        for (int turn = random.integer(1, 4); turn > 0; --turn)
            file[random.bits() % file.size()] = static_cast<char>(random.bits());
        auto zip = ZipReader::open(bytes_of(file), cli::inflate);
        if (!zip) continue;
        for (const ZipMember& member : zip->members()) {
            const auto bytes = zip->unpack(member);
            if (!bytes) continue;
            EXPECT_EQ(crc_of(text_of(*bytes)), member.checksum) << "seed " << seed;
        }
    }
}

}  // namespace
}  // namespace snug::test
