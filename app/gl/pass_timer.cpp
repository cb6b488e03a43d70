// pass_timer.cpp: timestamps between passes.
#include "app/gl/pass_timer.h"

#include <algorithm>

namespace neph::gl {

PassTimer::~PassTimer() {
    if (!marks_.empty()) glDeleteQueries(static_cast<GLsizei>(marks_.size()), marks_.data());
}

void PassTimer::start(bool on) {
    on_ = on;
    used_ = 0;
    names_.clear();
}

void PassTimer::mark() {
    if (used_ == marks_.size()) {
        GLuint query = 0;
        glCreateQueries(GL_TIMESTAMP, 1, &query);
        marks_.push_back(query);
    }
    glQueryCounter(marks_[used_++], GL_TIMESTAMP);
}

void PassTimer::pass(std::string_view name) {
    if (!on_) return;
    mark();
    names_.push_back(name);
}

std::vector<std::pair<std::string_view, double>> PassTimer::finish() {
    std::vector<std::pair<std::string_view, double>> times;
    if (!on_ || names_.empty()) return times;
    mark();
    GLuint64 before = 0;
    glGetQueryObjectui64v(marks_[0], GL_QUERY_RESULT, &before);
    for (std::size_t i = 0; i < names_.size(); ++i) {
        GLuint64 after = 0;
        glGetQueryObjectui64v(marks_[i + 1], GL_QUERY_RESULT, &after);
        const double milliseconds = static_cast<double>(after - before) * 1e-6;
        const auto known = std::find_if(times.begin(), times.end(),
                                        [&](const auto& time) { return time.first == names_[i]; });
        if (known == times.end()) {
            times.emplace_back(names_[i], milliseconds);
        } else {
            known->second += milliseconds;
        }
        before = after;
    }
    on_ = false;
    return times;
}

}  // namespace neph::gl
