add_block_lockstep(ik_cordic MODEL model_ik_cordic
  SOURCES ik_cordic/cordic.cpp ik_cordic/ik_cordic.cpp ik_cordic/ik_solver.cpp ik_cordic/ik_words.cpp)
