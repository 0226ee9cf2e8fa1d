// SPDX-License-Identifier: MIT
#include <array>
#include <exception>
#include <string>
#include <string_view>

#include "orthoball/error.h"
#include "orthoball/output/byte_sink.h"
#include "python/module.h"

namespace nb = nanobind;
using orthoball::InputError;

namespace {

const char* name_of(InputError::Reason reason) {
  switch (reason) {
    case InputError::Reason::not_finite:
      return "not_finite";
    case InputError::Reason::wrong_size:
      return "wrong_size";
    case InputError::Reason::wrong_argument:
      return "wrong_argument";
    case InputError::Reason::imaginary_ball:
      return "imaginary_ball";
  }
  return "";
}

// The types that Python sees; the module keeps them alive.
struct ErrorTypes {
  nb::handle input, parse, limit;
};
ErrorTypes types;

}  // namespace

std::string in_python(std::string message) {
  constexpr std::array<std::array<std::string_view, 2>, 11> kNames{{
      {"--input-format", "format="},
      {"--columns", "columns="},
      {"--radius-column 4", "radius_column=4"},
      {"--radii none", "radii=\"none\""},
      {"--default-radius", "default_radius="},
      {"--model N", "model=N"},
      {"--altloc X", "altloc=\"X\""},
      {"--hydrogens drop", "hydrogens=False"},
      {"--allow-empty", "allow_empty=True"},
      {"--no-limit", "limited=False"},
      {", or set another limit with --memory-limit", ""},
  }};
  for (const auto& [option, name] : kNames) {
    const std::size_t at = message.find(option);
    if (at != std::string::npos) message.replace(at, option.size(), name);
  }
  return message;
}

namespace {

nb::object made(nb::handle type, const std::exception& error) {
  return type(nb::str(in_python(error.what()).c_str()));
}

void raise(nb::handle type, const nb::object& error) { PyErr_SetObject(type.ptr(), error.ptr()); }

// Types derived from std::invalid_argument and the like, so that this translator must be asked
// before those of nanobind: the last that is registered is.
void translate(const std::exception_ptr& thrown, void* /*unused*/) {
  try {
    std::rethrow_exception(thrown);
  } catch (const InputError& error) {
    nb::object object = made(types.input, error);
    object.attr("reason") = name_of(error.reason());
    object.attr("row") = error.row() == InputError::kNoRow ? nb::none() : nb::cast(error.row());
    raise(types.input, object);
  } catch (const orthoball::ParseError& error) {
    nb::object object = made(types.parse, error);
    object.attr("file") = nb::str(error.file().c_str());
    object.attr("line") = error.line() == 0 ? nb::none() : nb::cast(error.line());
    raise(types.parse, object);
  } catch (const orthoball::LimitError& error) {
    raise(types.limit, made(types.limit, error));
  } catch (const orthoball::OutputError& error) {
    PyErr_SetString(PyExc_OSError, error.what());
  }
}

nb::handle new_type(nb::module_& module, const char* name, const char* doc) {
  const std::string full = std::string("orthoball._core.") + name;
  PyObject* const type = PyErr_NewExceptionWithDoc(full.c_str(), doc, PyExc_ValueError, nullptr);
  if (type == nullptr) throw nb::python_error();
  module.attr(name) = nb::steal(type);
  return type;
}

}  // namespace

void bind_errors(nb::module_& module) {
  types.input =
      new_type(module, "InputError",
               "The caller's numbers are not what the function accepts.\n\n"
               "Attributes: `reason` (\"not_finite\", \"wrong_size\", \"wrong_argument\",\n"
               "\"imaginary_ball\") and `row`, the input row from 0, or None where no single row "
               "is at fault.");
  types.parse =
      new_type(module, "ParseError",
               "A file is not what its format says: `FILE:LINE: what is wrong`.\n\n"
               "Attributes: `file` and `line`, from 1, or None where the whole file is meant.");
  types.limit = new_type(module, "LimitError",
                         "More of something than can be counted, or than memory allows.");
  nb::register_exception_translator(translate);
}
