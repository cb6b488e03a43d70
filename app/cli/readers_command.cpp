// readers_command.cpp: the list of reader plugins.
#include "app/cli/readers_command.h"

#include <fmt/format.h>

#include "core/plugin/plugin_host.h"

namespace neph {

int runReaders(std::span<const std::string> named) {
    const PluginHost host = PluginHost::standard(named);
    for (const auto& reader : host.readers()) {
        fmt::print("{} {}: {}\n  library     {}\n  ABI         {}\n  extensions  {}\n", reader->id,
                   reader->version, reader->title, reader->library.string(), reader->abiVersion,
                   reader->extensions.empty() ? "none" : reader->extensions);
    }
    if (host.readers().empty()) fmt::print("No readers were found.\n");
    if (!host.rejected().empty()) fmt::print("\nRejected\n");
    for (const auto& rejected : host.rejected()) {
        fmt::print("  {}: {}\n", rejected.library.string(), rejected.reason);
    }
    fmt::print("\nLooked for in\n");
    for (const auto& place : named) fmt::print("  {}\n", place);
    for (const auto& place : PluginHost::standardPlaces()) fmt::print("  {}\n", place.string());
    return host.readers().empty() ? 1 : 0;
}

}  // namespace neph
