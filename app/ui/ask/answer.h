// answer.h: a question whose answer is computed beside the panels: the newest question wins, and
// the last answer is shown until the next is there.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/base/jobs.h"

namespace neph::ui {

template <typename Question, typename Value>
class Answer {
  public:
    /// Runs on a worker of its own.
    using Work = std::function<Value(const Progress&)>;

    /// Asks, unless that was asked already. `work` is made only where it has to run.
    void ask(const Question& question, const std::function<Work()>& work) {
        if (asked_ && *asked_ == question) return;
        asked_ = question;
        fault_.clear();
        Work run;
        try {
            run = work();
        } catch (const Error& error) {
            fail(error);
            return;
        }
        jobs_.start(
            "",
            [this, run](const Progress& progress) -> Jobs::Finish {
                auto value = std::make_shared<Value>(run(progress));
                return [this, value] { value_ = std::move(*value); };
            },
            [this](const Error& error) { fail(error); });
    }
    /// Call once a frame.
    void poll() { jobs_.poll(); }

    const std::optional<Question>& asked() const { return asked_; }
    const std::optional<Value>& value() const { return value_; }
    const std::string& fault() const { return fault_; }
    bool busy() const { return jobs_.busy(); }
    double fraction() const { return jobs_.fraction(); }

  private:
    void fail(const Error& error) {
        jobs_.cancel();
        fault_ = error.message();
        value_.reset();
    }

    std::optional<Question> asked_;
    std::optional<Value> value_;
    std::string fault_;
    Jobs jobs_;  // last, so that the worker ends before the members it uses
};

}  // namespace neph::ui
