# Fails when an object file of one instruction set defines a symbol outside the set's own namespaces: the linker could
# then keep that copy for every other file, and processors without the instruction set would run it.
# cmake -DNM=nm "-DOBJECTS=a.o;b.o" -DISA=avx2 -P check_symbols.cmake
if(NOT OBJECTS)
  message(FATAL_ERROR "no object files were given")
endif()

# Mangled, because there the namespace precedes the type that a template returns: bodyline::model::isa::avx2 or
# bodyline::model::avx2, of a function, a guard or a local variable, type information, or a virtual table.
string(LENGTH ${ISA} length)
set(own "^_Z(GV|T[ISV])?Z?NK?8bodyline5model(3isa)?${length}${ISA}")

foreach(object IN LISTS OBJECTS)
  execute_process(COMMAND ${NM} --extern-only --defined-only --format=posix ${object}
                  OUTPUT_VARIABLE listing RESULT_VARIABLE failed)
  if(failed)
    message(FATAL_ERROR "${NM} failed on ${object}")
  endif()
  string(REGEX MATCHALL "[^\n]+" symbols "${listing}")
  if(NOT symbols)
    message(FATAL_ERROR "${object} defines nothing")
  endif()
  foreach(symbol IN LISTS symbols)
    string(REGEX REPLACE " .*" "" name "${symbol}")
    if(NOT name MATCHES "${own}")
      message(SEND_ERROR "${object} defines '${name}' outside its own namespace")
    endif()
  endforeach()
endforeach()
