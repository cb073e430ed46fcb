// AXI4-Lite between the crossbar and a block: the ports `s_axi_i` and `s_axi_o` carry the two directions of one bus.
//
// Types outside of a package, because Icarus 11 takes no struct from one.
`ifndef AXI_LITE_TYPES_SVH
`define AXI_LITE_TYPES_SVH

// What the master drives. AxPROT is not used.
typedef struct packed {
  logic [15:0] awaddr;  // bytes from the base of the block
  logic        awvalid;
  logic [31:0] wdata;
  logic [3:0]  wstrb;
  logic        wvalid;
  logic        bready;
  logic [15:0] araddr;
  logic        arvalid;
  logic        rready;
} axi_lite_req_t;

// What the slave drives.
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

// Widths of the two, for vectors of several ports: port i is at [i*W +: W].
localparam int AxiLiteReqBits = 2 * 16 + 32 + 4 + 5;
localparam int AxiLiteRspBits = 32 + 2 * 2 + 5;

`endif
