// file_kind_test.cpp: every kind that is recognised but not read, from bytes as the formats'
// descriptions have them, under names that say nothing.
#include "core/plugin/file_kind.h"

#include <doctest/doctest.h>

#include <array>
#include <cstdint>
#include <fstream>
#include <functional>
#include <map>

#include "core/plugin/file_address.h"
#include "tests/temporary_folder.h"
#include "tests/text.h"

using namespace neph;
using namespace std::string_literals;
namespace fs = std::filesystem;

namespace {

void write(const fs::path& file, const std::string& bytes) {
    fs::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << bytes;
}

std::string noise(std::size_t count) {
    std::string bytes;
    std::uint32_t state = 12345;
    while (bytes.size() < count) {
        state = state * 1664525U + 1013904223U;
        bytes += static_cast<char>(state >> 24U);
    }
    return bytes;
}

/// POSIX ustar: the header of a member of no bytes.
std::string tarHeader() {
    std::string header(512, '\0');
    header.replace(0, 12, "wrfout_d01_a");
    header.replace(100, 8, "0000644\0"s);
    header.replace(124, 12, "00000000000\0"s);
    header.replace(148, 8, "        ");
    header.replace(156, 1, "0");
    header.replace(257, 8, "ustar\00000"s);
    unsigned sum = 0;
    for (const char c : header) sum += static_cast<unsigned char>(c);
    std::string octal;
    for (; sum > 0; sum /= 8) octal.insert(octal.begin(), static_cast<char>('0' + sum % 8));
    header.replace(148, 8, std::string(6 - octal.size(), '0') + octal + "\0 "s);
    return header + std::string(1024, '\0');
}

std::string zipOf(const std::string& member) {
    std::string header = "PK\x03\x04"s + std::string(22, '\0');
    header += static_cast<char>(member.size());
    return header + std::string(3, '\0') + member + noise(40);
}

const std::string kHdf5 = "\x89HDF\r\n\x1a\n"s;

/// One file or folder of each kind, by the id of its row.
const std::map<std::string, std::function<void(const fs::path&)>>& samples() {
    const auto file = [](std::string bytes) {
        return [bytes = std::move(bytes)](const fs::path& path) { write(path, bytes); };
    };
    static const std::map<std::string, std::function<void(const fs::path&)>> all{
        {"empty", file("")},
        {"zarr", [](const fs::path& p) { write(p / ".zgroup", R"({"zarr_format": 2})"); }},
        {"adios",
         [](const fs::path& p) {
             write(p / "md.idx", noise(64));
             write(p / "data.0", noise(64));
         }},
        {"zarr-part", file(R"({"zarr_format": 3, "node_type": "group"})")},
        {"gzip-tar", file("\x1f\x8b\x08\x08"s + noise(6) + "run.tar\0"s + noise(50))},
        {"gzip", file("\x1f\x8b\x08\x00"s + noise(60))},
        {"compress", file("\x1f\x9d\x90"s + noise(60))},
        {"zstd", file("\x28\xb5\x2f\xfd"s + noise(60))},
        {"bzip2", file("BZh91AY&SY" + noise(60))},
        {"xz", file("\xfd"s + "7zXZ\0"s + noise(60))},
        {"lz4", file("\x04\x22\x4d\x18"s + noise(60))},
        {"numpy-zip", file(zipOf("qc.npy"))},
        {"zip", file(zipOf("wrfout_d01"))},
        {"7z", file("7z\xbc\xaf\x27\x1c"s + noise(60))},
        {"tar", file(tarHeader())},
        {"grib2", file("GRIB\0\0\0\2"s + noise(200))},
        {"grib1", file("\x01\r\r\n001 \r\r\nYTQA50 ECMF 010000\r\r\nGRIB\0\4\0\1"s + noise(200))},
        {"bufr", file("BUFR\0\1\0\4"s + noise(60))},
        {"hdf4", file("\x0e\x03\x13\x01"s + noise(60))},
        {"matlab", file("MATLAB 5.0 MAT-file, Platform: GLNXA64" + noise(100))},
        {"rams", file(kHdf5 + noise(90) + "DN0\0RCP\0THETA\0"s + noise(90))},
        {"hdf5", file(std::string(512, '\0') + kHdf5 + noise(200))},
        {"netcdf", file(kHdf5 + noise(90) + "_NCProperties" + noise(90))},
        {"openvdb", file(" BDV\0\0\0\0"s + noise(60))},
        {"nanovdb", file("NanoVDB0" + noise(60))},
        {"vtk-xml", file("<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"1.0\">")},
        {"vtk-legacy", file("# vtk DataFile Version 3.0\nclouds\nBINARY\n" + noise(60))},
        {"xdmf", file("<?xml version=\"1.0\"?>\n<!DOCTYPE Xdmf SYSTEM \"Xdmf.dtd\" []>\n<Xdmf>")},
        {"numpy",
         file("\x93NUMPY\x01\x00\x76\x00"s +
              "{'descr': '<f4', 'fortran_order': False, 'shape': (16, 32, 64), }" + noise(100))},
        {"lfs", file("version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 12345\n")},
        {"annex", file("/annex/objects/SHA256E-s123--4d7a.nc\n")},
        {"html", file("\r\n<!doctype HTML>\n<html><body>Please log in</body></html>")},
        {"xml", file("<Error><Code>AccessDenied</Code></Error>")},
        {"apple-double", file("\x00\x05\x16\x07\x00\x02\x00\x00"s + noise(60))},
        {"image", file("\x89PNG\r\n\x1a\n"s + noise(60))},
        {"utf16", file("\xff\xfe"s + "d\0s\0e\0t\0"s)},
        {"utf8-bom", file("\xef\xbb\xbf"s + "dset ^a.dat\n")},
        {"cdl", file("netcdf wrfout {\ndimensions:\n")},
        {"namelist", file("! of the run\n &time_control\n run_days = 1\n/\n")},
        {"json", file(R"({"cells": [1, 2]})")},
        {"text", file("taskid: 0 hostname: node17\n")},
        {"zeros", file(std::string(4096, '\0'))},
        {"fortran", file("\0\0\0\x28"s + noise(40) + "\0\0\0\x28"s)},
    };
    return all;
}

}  // namespace

TEST_CASE("Every kind is told by its content, whatever its name") {
    const TemporaryFolder folder;
    REQUIRE(samples().size() == fileKinds().size());
    for (const auto& sample : samples()) {
        const std::string& id = sample.first;
        CAPTURE(id);
        for (const char* name : {"wrfout_d01.nc", "bare", "a b.tar.gz", "x.zst"}) {
            const fs::path path = folder / id / name;
            fs::create_directories(path.parent_path());
            sample.second(path);
            const auto known = recogniseFile(path);
            REQUIRE(known.has_value());
            CHECK(known->row->id == id);
            CHECK(contains(known->what, std::string(known->row->what)));
            CHECK(known->step.find("FILE") == std::string::npos);
            CHECK(known->step.find("STEM") == std::string::npos);
        }
    }
}

TEST_CASE("Bare numbers, and what cannot be looked at, are no kind") {
    const TemporaryFolder folder;
    write(folder / "qc.bin", noise(4000));
    CHECK_FALSE(recogniseFile(folder / "qc.bin").has_value());
    CHECK_FALSE(recogniseFile(folder / "none").has_value());
    CHECK_FALSE(recogniseFile(folder.path()).has_value());
    CHECK_FALSE(recogniseFile("/dev/null").has_value());
    // Bytes that only look like the beginning of something.
    write(folder / "b", "BZh no archive but a line\n" + noise(300));
    CHECK_FALSE(recogniseFile(folder / "b").has_value());
    write(folder / "g", noise(30) + "GRIB\0\0\0\2"s + noise(90));
    CHECK_FALSE(recogniseFile(folder / "g").has_value());
}

TEST_CASE("Steps name the file as a shell takes it, and the command that its name needs") {
    const TemporaryFolder folder;
    const auto stepOf = [&](const std::string& name, const char* id) {
        samples().at(id)(folder / name);
        return recogniseFile(folder / name).value().step;
    };
    const std::string at = folder.path().string() + "/";
    CHECK(contains(stepOf("wrfout_d01_2001-01-01_00:00:00.gz", "gzip"),
                   "`gunzip -k " + at + "wrfout_d01_2001-01-01_00:00:00.gz` writes " + at +
                       "wrfout_d01_2001-01-01_00:00:00,"));
    // gunzip refuses a name without its ending.
    CHECK(contains(stepOf("wrfout_d02", "gzip"),
                   "`gzip -dc " + at + "wrfout_d02 > " + at + "wrfout_d02.out`"));
    CHECK(contains(stepOf("a.nc.zst", "zstd"), "`unzstd " + at + "a.nc.zst`"));
    CHECK(contains(stepOf("run 1.tar", "tar"), "`tar -xf '" + at + "run 1.tar'`"));
    CHECK(contains(stepOf("it's.zip", "zip"), "`unzip '" + at + "it'\\''s.zip'`"));
    // A path that holds the words the table has for it.
    CHECK(contains(stepOf("FILE.STEM.bz2", "bzip2"),
                   "`bunzip2 -k " + at + "FILE.STEM.bz2` writes " + at + "FILE.STEM,"));
    CHECK(contains(stepOf("z.zarr", "zarr"), " " + at + "z.zarr " + at + "z.nc`"));
}

TEST_CASE("What is known of a file is told with its kind") {
    const TemporaryFolder folder;
    const auto whatOf = [&](const char* id) {
        samples().at(id)(folder / id);
        return recogniseFile(folder / id).value().what;
    };
    // Version 1: ten bytes and a header of 0x76.
    CHECK(contains(whatOf("numpy"),
                   "<f4 of shape (16, 32, 64), the last index fastest, from byte "
                   "128 on"));
    CHECK(contains(whatOf("vtk-xml"), "ImageData"));
    CHECK(contains(whatOf("lfs"), "12345 bytes"));
    CHECK(contains(whatOf("fortran"), "40 bytes, big-endian"));
    CHECK(contains(whatOf("text"), "\"taskid: 0 hostname: node17\""));
}

TEST_CASE("Each row stands in the reference page, as it is in the table") {
    std::ifstream page(NEPH_TEST_SOURCE_DIR "/docs/readers.md");
    const std::string text((std::istreambuf_iterator<char>(page)), {});
    for (const FileKindRow& row : fileKinds()) {
        std::string step(row.step);
        for (std::size_t at = step.find('|'); at != step.npos; at = step.find('|', at + 2)) {
            step.insert(at, "\\");
        }
        const std::string line =
            "| " + std::string(row.what) + " | " + std::string(row.sign) + " | " + step + " |\n";
        CHECK_MESSAGE(contains(text, line), line);
    }
}

TEST_CASE("An address is told from a path, with the command that fetches it") {
    CHECK(contains(addressAdvice("https://a.org/wrfout_d01"),
                   "`curl -fLO https://a.org/wrfout_d01`"));
    CHECK(
        contains(addressAdvice("HTTP://a.org/x?y=1&z=2"), "`curl -fLO 'HTTP://a.org/x?y=1&z=2'`"));
    CHECK(
        contains(addressAdvice("s3://bucket/run/wrfout"), "`aws s3 cp s3://bucket/run/wrfout .`"));
    CHECK(contains(addressAdvice("gs://bucket/a.zarr"), "`gcloud storage cp "));
    CHECK(contains(addressAdvice("https://t.edu/thredds/dodsC/a.nc"),
                   "`nccopy https://t.edu/thredds/dodsC/a.nc data.nc`"));
    CHECK(contains(addressAdvice("dap4://t.edu/a"), "`nccopy dap4://t.edu/a data.nc`"));
    CHECK(contains(addressAdvice("file:///home/me/a.nc"), "path: /home/me/a.nc"));
    CHECK(contains(addressAdvice("rods://zone/a.nc"), "copy it to this machine first"));
    for (const char* path : {"wrfout_d01_2001-01-01_00:00:00", "/a//b", "C:\\runs\\a.nc", "./a://b",
                             "://x", "supercell"}) {
        CAPTURE(path);
        CHECK(addressAdvice(path).empty());
    }
    CHECK(addressIn("/home/me/https://a.org") == std::size_t{9});
    CHECK_FALSE(addressIn("/home//me").has_value());
}
