// AXI4-Lite between the crossbar and a block. The ports `s_axi_i` and `s_axi_o` are the two directions of one bus.
//
// The types are not in a package, because Icarus 11 cannot use a struct from a package.
`ifndef AXI_LITE_TYPES_SVH
`define AXI_LITE_TYPES_SVH

// Signals that the master drives. AxPROT is not used.
typedef struct packed {
  logic [15:0] awaddr;  // byte offset from the base address of the block; araddr likewise
  logic        awvalid;
  logic [31:0] wdata;
  logic [3:0]  wstrb;
  logic        wvalid;
  logic        bready;
  logic [15:0] araddr;
  logic        arvalid;
  logic        rready;
} axi_lite_req_t;

// Signals that the slave drives.
typedef struct packed {
  logic        awready;
  logic        wready;
  logic [1:0]  bresp;
  logic        bvalid;
  logic        arready;
  logic [31:0] rdata;
  logic [1:0]  rresp;
  logic        rvalid;
} axi_lite_rsp_t;

// Widths of both structs in bits, for vectors of several ports: port i is at [i*W +: W].
localparam int AxiLiteReqBits = 2 * 16 + 32 + 4 + 5;
localparam int AxiLiteRspBits = 32 + 2 * 2 + 5;

`endif
