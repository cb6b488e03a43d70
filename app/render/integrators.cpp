// integrators.cpp: one maker for each row of the table of engines.
#include "app/render/integrators.h"

namespace neph::render {

#define NEPH_ENGINE(name, ...) \
    template <>                \
    std::unique_ptr<Integrator> makeIntegrator<Engine::name>();
#include "core/look/engine_rows.inc"

std::unique_ptr<Integrator> makeIntegrator(Engine engine) {
    switch (engine) {
#define NEPH_ENGINE(name, ...) \
    case Engine::name:         \
        return makeIntegrator<Engine::name>();
#include "core/look/engine_rows.inc"
    }
    return nullptr;
}

}  // namespace neph::render
