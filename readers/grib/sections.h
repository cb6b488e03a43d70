// sections.h: the fields of a GRIB2 file, found by the lengths of sections; no data are read.
//
// A message has one section 0 and 1, and sections 2 to 7, 3 to 7 or 4 to 7 once for each field.
// Sections are kept whole, with their length and number. Edition 2, WMO No. 306, volume I.2, FM 92.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "readers/grib/input_file.h"

namespace grib {

/// One field of a message.
struct Field {
    std::size_t message = 0;  ///< counted from 1, as wgrib2 and grib_ls do
    std::size_t part = 0;     ///< counted from 1 within the message
    unsigned discipline = 0;  ///< code table 0.0
    /// Sections 1 and 3, shared by the fields that have the same.
    std::shared_ptr<const Bytes> identification, grid;
    Bytes product, packing;  ///< sections 4 and 5
    Extent bitmap;           ///< section 6 with the bitmap that applies; no length where none does
    Extent data;             ///< section 7
};

/// What a file holds.
struct Inventory {
    std::vector<Field> fields;
    std::size_t messages = 0;          ///< of any edition, whole ones
    std::size_t otherEdition = 0;      ///< messages of edition 1
    std::vector<std::size_t> damaged;  ///< numbers of messages that are left out
    std::optional<Extent> unfinished;  ///< the last message, where the file ends within it
};

/// Offset of the first message in the head of a file, perhaps behind a bulletin's heading; nothing
/// if it is no GRIB.
std::optional<std::size_t> messageStart(ByteSpan head);

/// Reads the headers of all messages. Throws Failure if the file cannot be read.
Inventory scan(const InputFile& file);

/// The field as a message of its own, for ecCodes; without data where `values` is false.
Bytes messageOf(const InputFile& file, const Field& field, bool values);

}  // namespace grib
