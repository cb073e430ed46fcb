// Interface between axi_lite_slave and the register file, inside a block.
`ifndef REG_ACCESS_TYPES_SVH
`define REG_ACCESS_TYPES_SVH

// Accesses to the registers of a block, from axi_lite_slave. Addresses are byte offsets in the block; a register file
// ignores bits 1:0.
typedef struct packed {
  logic        we;     // write strobe: one clock per write, also when no byte is enabled
  logic [15:0] waddr;
  logic [31:0] wdata;
  logic [3:0]  wstrb;  // byte enables
  logic        re;     // read strobe: one clock per read
  logic [15:0] raddr;
} reg_req_t;

// Responses of the register file.
typedef struct packed {
  logic        werr;   // write error; valid in the clock after we
  logic [31:0] rdata;  // valid from the clock after re, held until the next re
  logic        rerr;   // read error; valid with rdata
} reg_rsp_t;

`endif
