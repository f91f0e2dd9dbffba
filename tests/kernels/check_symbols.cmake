# Fails when an object file of one instruction set defines a symbol that another object could share:
# cmake -DNM=nm -DOBJECT=file.o -DISA=avx2 -P check_symbols.cmake
execute_process(COMMAND ${NM} --extern-only --defined-only --demangle ${OBJECT} OUTPUT_VARIABLE listing RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "${NM} failed on ${OBJECT}")
endif()
string(REGEX MATCHALL "[^\n]+" symbols "${listing}")
if(NOT symbols)
  message(FATAL_ERROR "${OBJECT} defines nothing")
endif()
foreach(symbol IN LISTS symbols)
  string(REGEX REPLACE "^[0-9a-f]+ . " "" name "${symbol}")
  # A template's name starts with its return type; nothing but plain types may stand before the namespace.
  if(NOT name MATCHES "^((void|double) )?bodyline::model::isa::${ISA}::")
    message(FATAL_ERROR "${OBJECT} defines '${name}' outside its own namespace")
  endif()
endforeach()
