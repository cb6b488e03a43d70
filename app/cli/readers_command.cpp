// readers_command.cpp: the list of reader plugins, and the roles that one gave variables.
#include "app/cli/readers_command.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/cli/info/info_json.h"
#include "core/dataset/dataset.h"
#include "core/dataset/file_list.h"
#include "core/plugin/plugin_host.h"

namespace neph {
namespace {

std::string roleText(const VariableInfo& variable) {
    std::string text(roleId(variable.role));
    if (variable.species) text += fmt::format(" of {}", info(*variable.species).id);
    return text;
}

void printRoles(const DatasetInfo& data) {
    std::size_t name = 8, role = 4, units = 4;
    for (const VariableInfo& variable : data.variables) {
        if (variable.role == VariableRole::other && variable.reason.empty()) continue;
        name = std::max(name, variable.name.size());
        role = std::max(role, roleText(variable).size());
        units = std::max(units, variable.units.size());
    }
    fmt::print("{:<{}}  {:<{}}  {:<{}}  why\n", "variable", name, "role", role, "unit", units);
    for (const VariableInfo& variable : data.variables) {
        if (variable.role == VariableRole::other && variable.reason.empty()) continue;
        fmt::print("{:<{}}  {:<{}}  {:<{}}  {}\n", variable.name, name, roleText(variable), role,
                   variable.units, units,
                   variable.reason.empty() ? "not stated by the reader" : variable.reason);
    }
}

int explain(const std::vector<std::string>& files, const PluginHost& host) {
    const auto dataset = Dataset::open(listFiles(files), host);
    const DatasetInfo& data = dataset->info();
    fmt::print("Reader   {}\nModel    {}\nScheme   {}\n\n", data.reader, data.model,
               data.scheme.empty() ? "unknown" : data.scheme);
    printRoles(data);
    std::string rest;
    for (const VariableInfo& variable : data.variables) {
        if (variable.role != VariableRole::other || !variable.reason.empty()) continue;
        rest += (rest.empty() ? "" : ", ") + variable.name;
    }
    if (!rest.empty()) fmt::print("\nWithout a role: {}\n", rest);
    if (!data.notes.empty()) fmt::print("\nLeft out or assumed\n");
    for (const std::string& note : data.notes) fmt::print("  {}\n", note);
    return 0;
}

}  // namespace

int runReaders(const ReadersRequest& request) {
    const std::vector<std::string>& named = request.readers;
    const PluginHost host = PluginHost::standard(named, request.map);
    if (!request.explain.empty()) return explain(request.explain, host);
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
