// tutorial_test.cpp: the commands of docs/tutorial-evaluate.md and their answers, where the runs
// that it is about are. The numbers were computed from the files by numpy.
#include <doctest/doctest.h>

#include <filesystem>
#include <regex>

#include "tests/cli/program.h"

namespace {

const std::string kData = NEPH_TEST_SOURCE_DIR "/../shared/data/";
const std::string kWrf = "'" + kData + "wrf-supercell'", kCm1 = "'" + kData + "cm1-supercell'";

struct Question {
    std::string command;
    std::vector<std::string>
        answers;  ///< parts of what is printed, or of the table that is written
};

const std::vector<Question>& questions() {
    static const std::vector<Question> all{
        {"series " + kWrf + " -o OUT.csv",
         {"5400.87", "11731.27", "13867.42", "15149.83,1123.28,0.2715909", "56.1875,47500,47500",
          "14.22119,38500,68500,5184.148", "15.25879,"}},
        {"section " + kWrf + " --time 2 --height 5000 --show w -o OUT.csv", {"greatest 28.25"}},
        {"section " + kWrf + " --time 3 --height 5000 --show w -o OUT.csv",
         {"greatest 31.93 at x 47.5, y 58.5 km"}},
        {"probe " + kWrf + " --time 6 --at 5.5,5.5",
         {"0 °C      at 3825 m", "tropopause at 12200"}},
        {"series " + kCm1 + " -o OUT.csv",
         {"58,46875,51875,10750", "68.625,", "68.25,", "68.375,"}},
        {"section " + kCm1 + " --time 1 --height 4750 --show vorticity -o OUT.csv",
         {"greatest 21.13 at x 35.6, y 73.1 km", "least -18.87"}},
        {"section " + kCm1 +
             " --time 1 --from 47,40 --to 47,64 --show w --contours reflectivity -o OUT.png",
         {"greatest 55.65"}},
        {"probe " + kCm1 + " --time 1 --at 60,20", {"shear, 0 to 6 km      34.5, 7.2 m/s"}},
        {"profile " + kWrf + " --time 6 --at 38.5,68.5 -o OUT.csv", {"5184.148,", "14.22119"}},
    };
    return all;
}

}  // namespace

TEST_CASE("The tutorial's commands give its answers" *
          doctest::skip(!std::filesystem::is_directory(kData))) {
    for (const Question& question : questions()) {
        CAPTURE(question.command);
        const TemporaryFolder folder;
        const std::string out = (folder / "out").string();
        const std::string command = std::regex_replace(question.command, std::regex("OUT"), out);
        const Outcome outcome = runProgram(command);
        REQUIRE(outcome.status == 0);
        const std::string said = outcome.out + readText(out + ".csv");
        for (const std::string& answer : question.answers) {
            CAPTURE(answer);
            CHECK(contains(said, answer));
        }
    }
}

TEST_CASE("The tutorial has the answers that are tested") {
    const std::string tutorial = readText(NEPH_TEST_SOURCE_DIR "/docs/tutorial-evaluate.md");
    for (const char* number : {"5.4 km", "13.9 km", "56.2 m/s", "14.22 g/kg", "15.15 km", "3825 m",
                               "21.1", "-18.9", "35.2 m/s", "1123 m"}) {
        CAPTURE(number);
        CHECK(contains(tutorial, number));
    }
}
