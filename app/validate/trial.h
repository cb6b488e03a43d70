// trial.h: one measurement of a small scene, what it should come to, and what it came to.
//
// A quantity is a weighted sum of what detectors read. It is right when it is within its tolerance
// and three standard errors of what is expected, and the standard error is no larger than the
// tolerance, so that noise alone passes nothing.
#pragma once
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/render/engines/reference/trace_meter.h"

namespace neph::validate {

struct Term {
    std::size_t detector = 0;  ///< index in Trial::detectors
    double factor = 1.0;
};

struct Expected {
    double value = 0.0;
    double tolerance = 0.0;  ///< absolute
    std::string source;      ///< where it differs from the trial's
};

/// offset + the terms' sum.
struct Quantity {
    std::string name;
    std::vector<Term> terms;
    double offset = 0.0;
    std::optional<Expected> expected;
};

/// Another way to the same quantities.
struct Twin {
    render::MeterScene scene;
    render::MeterSettings settings;
};

struct Trial {
    std::string name, source;
    render::MeterScene scene;
    render::MeterSettings settings;  ///< the number of samples is the runner's to choose
    std::vector<render::Detector> detectors;
    std::vector<Quantity> quantities;
    /// Where there is one, what it measures is what is expected, not Expected::value.
    std::optional<Twin> twin;
    bool quick = true;  ///< is part of a quick run
};

/// A line of the report. Without an expectation nothing is judged.
struct Row {
    std::string trial, quantity, source;
    std::optional<double> expected;
    double measured = 0.0, sigma = 0.0, tolerance = 0.0;
    std::uint64_t samples = 0;
};

enum class Verdict { none, pass, fail, noisy };

inline Verdict verdict(const Row& row) {
    constexpr double kSigmas = 3.0;
    if (!row.expected) return Verdict::none;
    const double away = std::abs(row.measured - *row.expected);
    if (!(away <= row.tolerance + kSigmas * row.sigma)) return Verdict::fail;
    return row.sigma <= row.tolerance ? Verdict::pass : Verdict::noisy;
}

}  // namespace neph::validate
