add_block_lockstep(encoder MODEL "model_encoder;model_encoder_single" SOURCES encoder/encoder.cpp)
