add_block_lockstep(policy_mlp MODEL model_policy_mlp
  SOURCES policy_mlp/network_run.cpp policy_mlp/policy_mlp.cpp)
