// trial.h: measurements of a small scene, their expected results and the verdict.
//
// A quantity is a weighted sum of detector readings. It passes if it is within its tolerance plus
// three standard errors of the expected value, and its standard error is no larger than the
// tolerance, so that noise alone passes nothing.
#pragma once
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/render/engines/reference/trace_meter.h"

namespace neph::validate {

/// A reading and its weight.
struct Term {
    std::size_t detector = 0;  ///< index in Trial::detectors
    double factor = 1.0;
};

struct Expected {
    double value = 0.0;
    double tolerance = 0.0;  ///< absolute
    std::string source;      ///< if it differs from that of the trial
};

/// `offset` plus the sum of the terms.
struct Quantity {
    std::string name;
    std::vector<Term> terms;
    double offset = 0.0;
    std::optional<Expected> expected;
};

/// Another scene in which the same quantities must result.
struct Twin {
    render::MeterScene scene;
    render::MeterSettings settings;
};

/// One scene with its detectors. The name also determines the seed, so a renamed trial measures
/// slightly different values.
struct Trial {
    std::string name, source;
    render::MeterScene scene;
    render::MeterSettings settings;  ///< the runner chooses the number of samples
    std::vector<render::Detector> detectors;
    std::vector<Quantity> quantities;
    /// If present, its results replace Expected::value.
    std::optional<Twin> twin;
    bool quick = true;  ///< part of a quick run
};

/// A line of the report. Without an expected value there is no verdict.
struct Row {
    std::string trial, quantity, source;
    std::optional<double> expected;
    double measured = 0.0, sigma = 0.0, tolerance = 0.0;
    std::uint64_t samples = 0;
};

enum class Verdict { none, pass, fail, noisy };

/// A result that is not a number fails.
inline Verdict verdict(const Row& row) {
    constexpr double kSigmas = 3.0;
    if (!row.expected) return Verdict::none;
    const double away = std::abs(row.measured - *row.expected);
    if (!(away <= row.tolerance + kSigmas * row.sigma)) return Verdict::fail;
    return row.sigma <= row.tolerance ? Verdict::pass : Verdict::noisy;
}

}  // namespace neph::validate
