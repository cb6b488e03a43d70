// integrators.h: from an engine to its integrator.
#pragma once
#include <memory>

#include "app/render/frame/integrator.h"

namespace neph::render {

/// A new one, which has drawn nothing yet.
std::unique_ptr<Integrator> makeIntegrator(Engine engine);

}  // namespace neph::render
