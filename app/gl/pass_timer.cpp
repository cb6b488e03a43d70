// pass_timer.cpp: sets marks between passes, by the clock of the GPU or of the CPU.
#include "app/gl/pass_timer.h"

#include <algorithm>

#include "app/gl/context.h"

namespace neph::gl {

PassTimer::~PassTimer() {
    if (!queries_.empty()) glDeleteQueries(static_cast<GLsizei>(queries_.size()), queries_.data());
}

void PassTimer::start(bool on) {
    on_ = on;
    used_ = 0;
    clock_.clear();
    names_.clear();
    if (on && !software_) software_ = deviceMemory().software;
}

void PassTimer::mark() {
    if (*software_) {
        glFinish();
        clock_.push_back(std::chrono::steady_clock::now());
        return;
    }
    if (used_ == queries_.size()) {
        GLuint query = 0;
        glCreateQueries(GL_TIMESTAMP, 1, &query);
        queries_.push_back(query);
    }
    glQueryCounter(queries_[used_++], GL_TIMESTAMP);
}

void PassTimer::pass(std::string_view name) {
    if (!on_) return;
    mark();
    names_.push_back(name);
}

/// Milliseconds from the first mark to each mark. Waits for the results of the queries.
std::vector<double> PassTimer::markMs() const {
    std::vector<double> marks;
    for (const auto& time : clock_) {
        marks.push_back(std::chrono::duration<double, std::milli>(time - clock_.front()).count());
    }
    GLuint64 first = 0;
    for (std::size_t i = 0; i < used_; ++i) {
        GLuint64 nanoseconds = 0;
        glGetQueryObjectui64v(queries_[i], GL_QUERY_RESULT, &nanoseconds);
        if (i == 0) first = nanoseconds;
        marks.push_back(static_cast<double>(nanoseconds - first) * 1e-6);
    }
    return marks;
}

std::vector<std::pair<std::string_view, double>> PassTimer::finish() {
    std::vector<std::pair<std::string_view, double>> times;
    if (!on_ || names_.empty()) return times;
    mark();
    on_ = false;
    const std::vector<double> marks = markMs();
    for (std::size_t i = 0; i < names_.size(); ++i) {
        const double milliseconds = marks[i + 1] - marks[i];
        const auto known = std::find_if(times.begin(), times.end(),
                                        [&](const auto& time) { return time.first == names_[i]; });
        if (known == times.end()) {
            times.emplace_back(names_[i], milliseconds);
        } else {
            known->second += milliseconds;
        }
    }
    return times;
}

}  // namespace neph::gl
